// What can be shown over the stage.

import type { Words } from "..";

export const see: Words["see"] = {
  heading: "Sehen",
};
