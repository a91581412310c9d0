// The stage.

import type { Words } from "..";

export const stage: Words["stage"] = {
  label: "Die Bühne: Punkte, Kanten und Dreiecke",
  fit: "Einpassen",
  zoomIn: "Vergrößern",
  zoomOut: "Verkleinern",
};
