// Guessing the next flip.

export const predict = {
  heading: "Predict the next flip",
  rules:
    "The algorithm stands before a flip. Which edge will it be? Look for circles that are not empty, and at the order in which the algorithm goes.",
  difficulty: "Which edges",
  difficulties: { three: "one of three", all: "any edge" },
  ask: {
    three: "Which of the three is flipped next? Click on it, or press 1, 2 or 3.",
    all: "Which edge is flipped next? Click on it; or choose with the arrow keys, and Enter.",
  },
  loading: "Looking for the next flip …",
  bar: "The question",
  choices: "Edges to choose from",
  hint: "Hint",
  hintHint: "Show the edges that are not locally Delaunay",
  next: "Next puzzle",
  skip: "Another one",
  again: "From the beginning",
  over: "No flip is left.",
  noFlips: "This algorithm makes no flips here. One of these does:",
  score: "Score",
  right: "right",
  streak: "in a row",
  best: "best row",
  verdicts: {
    right: "Right!",
    almost: "Almost: that edge must go too, but not yet.",
    wrong: "No.",
  },
  flipped: (edge: string, made: string) => `Edge ${edge} is flipped to ${made}`,
  inside: (edge: string, v: number, c: number) =>
    `: vertex ${v} lies inside the circle through ${edge} and ${c}, so the edge is not locally Delaunay.`,
  onInside: (edge: string, v: number, c: number) =>
    `: vertex ${v} lies exactly on the circle through ${edge} and ${c}; the tie-break counts it as inside.`,
  decided: (test: string) => `. ${test} Here that decides, not the circle.`,
  stays: (edge: string, v: number, c: number) =>
    `Edge ${edge} is locally Delaunay: vertex ${v} lies outside the circle through it and ${c}.`,
  staysOn: (edge: string, v: number, c: number) =>
    `Edge ${edge} may stay: vertex ${v} lies exactly on the circle through it and ${c}, and the tie-break counts it as outside.`,
};
