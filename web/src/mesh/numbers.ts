// Numbers as people write them, and sizes that suit a drawing.

/** Reads a number that somebody has written, with a point or a comma; null if it is none. */
export function readNumber(text: string): number | null {
  const plain = text.trim().replace(",", ".");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

/** Rounds to one or two digits that people like: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten. */
export function nice(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = Math.floor(Math.log10(value));
  const digits = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];
  const lead = value / 10 ** power;
  const best = digits.reduce((a, b) => (Math.abs(b - lead) < Math.abs(a - lead) ? b : a));
  // By way of a text, so that no 0.30000000000000004 comes of it.
  return Number(`${best}e${power}`);
}
