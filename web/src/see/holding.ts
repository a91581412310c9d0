// Data, by the triangle for which they count.

import { NONE } from "../engine/protocol";

/** Gathers data by the triangle that holds them. `rows` are three vertices for each datum, or NONE. */
export function byHolder(rows: ArrayLike<number>): { triangle: number[]; data: number[] }[] {
  const found = new Map<string, { triangle: number[]; data: number[] }>();
  for (let v = 0; 3 * v < rows.length; v++) {
    const triangle = [rows[3 * v], rows[3 * v + 1], rows[3 * v + 2]];
    if (triangle[0] === NONE) continue;
    const key = triangle.join(" ");
    const holder = found.get(key) ?? { triangle, data: [] };
    holder.data.push(v);
    found.set(key, holder);
  }
  return [...found.values()];
}
