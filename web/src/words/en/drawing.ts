// Drawings: presets, tools, editing.

export const drawing = {
  heading: "Drawing",
  preset: "Preset",
  kinds: { points: "Points", domain: "Domains", scene: "Examples" },
  count: "Number of points",
  seed: "Seed",
  another: "Another seed",
  summary: (points: string, segments: string, holes: string) =>
    `${points} points, ${segments} segments, ${holes} holes`,
};
