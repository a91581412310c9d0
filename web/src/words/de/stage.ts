// The stage.

import type { Words } from "..";

export const stage: Words["stage"] = {
  label: "Die Bühne: Punkte, Kanten und Dreiecke",
  keys: "Pfeiltasten verschieben die Ansicht, mit Umschalttaste weiter; Plus und Minus vergrößern und verkleinern, Null zeigt alles.",
  view: "Ansicht",
  fit: "Einpassen",
  zoomIn: "Vergrößern",
  zoomOut: "Verkleinern",
};
