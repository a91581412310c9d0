// The colours of the stage, as the style sheet has them for the theme.

export interface Palette {
  paper: string;
  ink: string;
  edge: string;
  locked: string;
  fill: string;
  good: string;
  bad: string;
  asked: string;
  front: string;
  sweep: string;
  soft: string;
}

const names: (keyof Palette)[] = [
  "paper",
  "ink",
  "edge",
  "locked",
  "fill",
  "good",
  "bad",
  "asked",
  "front",
  "sweep",
  "soft",
];

/** Reads the colours that hold at an element: custom properties `--stage-…`. */
export function readPalette(element: Element): Palette {
  const style = getComputedStyle(element);
  const colours = names.map((name) => [name, style.getPropertyValue(`--stage-${name}`).trim()]);
  return Object.fromEntries(colours) as Palette;
}

/** Returns a colour of the palette, `#rrggbb`, with a share of its strength. */
export function pale(colour: string, share: number): string {
  const level = Math.round(255 * Math.max(0, Math.min(1, share)));
  return `${colour}${level.toString(16).padStart(2, "0")}`;
}
