// Places of vertices.

import type { Coordinates } from "../engine/protocol";

/** Returns the place of a vertex. */
export const placeOf = (points: Coordinates, v: number): [x: number, y: number] => [
  points[2 * v],
  points[2 * v + 1],
];

/** Returns the middle of some vertices. */
export function middleOf(points: Coordinates, vertices: ArrayLike<number>): [x: number, y: number] {
  let [x, y] = [0, 0];
  for (let i = 0; i < vertices.length; i++) {
    // Parts first: coordinates may be as large as numbers go.
    x += points[2 * vertices[i]] / vertices.length;
    y += points[2 * vertices[i] + 1] / vertices.length;
  }
  return [x, y];
}
