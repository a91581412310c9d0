// Playing an algorithm.

export const play = {
  heading: "Algorithm",
  algorithm: "Algorithm",
  play: "Play",
  pause: "Pause",
  next: "Step",
  previous: "Step back",
  first: "To the beginning",
  last: "To the end",
  position: "Position",
  of: (position: string, length: string) => `${position} of ${length}`,
  speed: "Steps a second",
  code: "Pseudocode",
  begin: "Before the first step.",
};
