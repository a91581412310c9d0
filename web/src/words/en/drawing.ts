// Drawings: presets, tools, editing.

import { presets } from "./presets";

export const drawing = {
  presets,
  heading: "Drawing",
  preset: "Preset",
  kinds: { points: "Points", domain: "Domains", scene: "Examples" },
  chosen: "Own drawing",
  count: { points: "Points", segments: "Segments" },
  seed: "Seed",
  another: "Another seed",
  empty: "Start empty",
  tools: {
    label: "Tools",
    view: "Move the view",
    points: "Points",
    segments: "Segments",
    holes: "Holes",
    erase: "Erase",
  },
  hints: {
    points: "Click to add a point, drag one to move it; Shift-click or the eraser removes it.",
    segments: "Click from point to point; the first one closes the ring, the last one again ends.",
    holes: "Click inside a hole to mark it; click a mark to remove it.",
    erase: "Click a point, a segment or the mark of a hole to remove it.",
  },
  undo: "Undo",
  redo: "Redo",
  keys: { undo: "Ctrl+Z", redo: "Ctrl+Shift+Z" },
  clear: "Remove everything",
  exact: "By numbers",
  addPoint: "Add point",
  addHole: "Add hole",
  from: "from",
  to: "to",
  addSegment: "Add segment",
  summary: (points: string, segments: string, holes: string) =>
    `Points: ${points}, segments: ${segments}, holes: ${holes}`,
};
