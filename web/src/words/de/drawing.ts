// Drawings: presets, tools, editing.

import type { Words } from "..";
import { presets } from "./presets";

export const drawing: Words["drawing"] = {
  presets,
  heading: "Zeichnung",
  preset: "Vorlage",
  kinds: { points: "Punkte", domain: "Gebiete", scene: "Beispiele" },
  chosen: "Eigene Zeichnung",
  count: { points: "Punkte", segments: "Strecken" },
  seed: "Startwert",
  another: "Anderer Startwert",
  empty: "Leer beginnen",
  tools: {
    label: "Werkzeuge",
    view: "Ansicht bewegen",
    points: "Punkte",
    segments: "Strecken",
    holes: "Löcher",
    erase: "Löschen",
  },
  hints: {
    points: "Klick fügt einen Punkt hinzu, Ziehen bewegt ihn; Umschalt-Klick oder Löschen entfernt ihn.",
    segments: "Klick von Punkt zu Punkt; der erste schließt den Ring, der letzte nochmals beendet.",
    holes: "Klick in ein Loch markiert es; Klick auf eine Marke entfernt sie.",
    erase: "Klick auf Punkt, Strecke oder Lochmarke entfernt sie.",
  },
  undo: "Rückgängig",
  redo: "Wiederholen",
  keys: { undo: "Strg+Z", redo: "Strg+Umschalt+Z" },
  clear: "Alles entfernen",
  exact: "Mit Zahlen",
  addPoint: "Punkt hinzufügen",
  addHole: "Loch hinzufügen",
  from: "von",
  to: "nach",
  addSegment: "Strecke hinzufügen",
  summary: (points, segments, holes) => `Punkte: ${points}, Strecken: ${segments}, Löcher: ${holes}`,
};
