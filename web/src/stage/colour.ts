// Colours of style sheets as numbers.

type Rgba = readonly [number, number, number, number];

const known = new Map<string, Rgba>();
let context: CanvasRenderingContext2D | null | undefined;

/** Returns red, green and blue, multiplied by alpha, and alpha, from 0 to 1, of a colour as style sheets write it. */
export function colourOf(written: string): Rgba {
  const colour = known.get(written) ?? read(written);
  known.set(written, colour);
  return colour;
}

/** The browser knows best what the words mean. */
function read(written: string): Rgba {
  context ??= document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  if (!context) return [0, 0, 0, 1];
  context.clearRect(0, 0, 1, 1);
  context.fillStyle = written;
  context.fillRect(0, 0, 1, 1);
  const [red, green, blue, alpha] = [...context.getImageData(0, 0, 1, 1).data].map((part) => part / 255);
  return [red * alpha, green * alpha, blue * alpha, alpha];
}
