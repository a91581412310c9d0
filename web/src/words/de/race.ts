// Races.

import type { Words } from "..";

export const race: Words["race"] = {
  heading: "Rennen",
};
