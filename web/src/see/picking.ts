// What lies under the pointer, by looking at everything once: quick enough for a hand. Rounded: a hand is no predicate.

import type { Coordinates, Indices } from "../engine/protocol";

/** Returns the edge, by its place in the list, that is nearest to a place; -1 if there is none. */
export function nearestEdge(points: Coordinates, edges: Indices, x: number, y: number): number {
  let [best, least] = [-1, Number.POSITIVE_INFINITY];
  for (let e = 0; e < edges.length; e += 2) {
    const [a, b] = [2 * edges[e], 2 * edges[e + 1]];
    const [px, py] = [x - points[a], y - points[a + 1]];
    const [dx, dy] = [points[b] - points[a], points[b + 1] - points[a + 1]];
    const share = Math.max(0, Math.min(1, (px * dx + py * dy) / (dx * dx + dy * dy) || 0));
    const [rx, ry] = [px - share * dx, py - share * dy];
    const far = rx * rx + ry * ry;
    if (far < least) [best, least] = [e / 2, far];
  }
  return best;
}

/** Returns the triangle at a place, by its number; -1 outside. */
export function triangleAt(points: Coordinates, triangles: Indices, x: number, y: number): number {
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
    if (isLeft(points, a, b, x, y) && isLeft(points, b, c, x, y) && isLeft(points, c, a, x, y)) return t / 3;
  }
  return -1;
}

function isLeft(points: Coordinates, a: number, b: number, x: number, y: number): boolean {
  const [ax, ay] = [points[a], points[a + 1]];
  return (points[b] - ax) * (y - ay) - (points[b + 1] - ay) * (x - ax) >= 0;
}
