// Drawings: presets, tools, editing.

import type { Words } from "..";

export const drawing: Words["drawing"] = {
  heading: "Zeichnung",
  preset: "Vorlage",
  kinds: { points: "Punkte", domain: "Gebiete", scene: "Beispiele" },
  count: "Anzahl der Punkte",
  seed: "Startwert",
  another: "Anderer Startwert",
  summary: (points, segments, holes) => `${points} Punkte, ${segments} Strecken, ${holes} Löcher`,
};
