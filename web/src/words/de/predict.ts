// Guessing the next flip.

import type { Words } from "..";

export const predict: Words["predict"] = {
  heading: "Die nächste Kippung vorhersagen",
};
