// Whether somebody wants the same as before.

/** Tells whether two things are wanted that are the same. */
export function isSame(one: object, other: object): boolean {
  const [a, b] = [Object.entries(one), Object.entries(other)];
  const values = new Map<string, unknown>(b);
  return a.length === b.length && a.every(([key, value]) => Object.is(values.get(key), value));
}
