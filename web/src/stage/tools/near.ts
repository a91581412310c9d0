// What of a drawing lies near a place. Linear: a look at a million points takes a few milliseconds, and an index would
// have to be made anew after each edit.

import type { Coordinates, Indices } from "../../engine/protocol";

/** Returns the point nearest to a place within a radius, the first of equals; null if there is none. */
export function nearestPoint(points: Coordinates, x: number, y: number, radius: number): number | null {
  let [best, least] = [-1, radius];
  for (let i = 0; i < points.length; i += 2) {
    const [dx, dy] = [Math.abs(points[i] - x), Math.abs(points[i + 1] - y)];
    // Most are far away, and roots take their time.
    if (!(dx <= least && dy <= least)) continue;
    const distance = Math.hypot(dx, dy);
    if (distance < least || (distance === least && best < 0)) [best, least] = [i / 2, distance];
  }
  return best < 0 ? null : best;
}

/** Returns the segment nearest to a place within a radius; null if there is none. */
export function nearestSegment(
  points: Coordinates,
  segments: Indices,
  x: number,
  y: number,
  radius: number,
): number | null {
  let [best, least] = [-1, radius];
  for (let k = 0; k < segments.length; k += 2) {
    const [a, b] = [2 * segments[k], 2 * segments[k + 1]];
    const [ax, ay, bx, by] = [points[a], points[a + 1], points[b], points[b + 1]];
    if (isBeyond(x, ax, bx, least) || isBeyond(y, ay, by, least)) continue;
    const distance = toSegment(x, y, ax, ay, bx, by);
    if (distance < least) [best, least] = [k / 2, distance];
  }
  return best < 0 ? null : best;
}

/** Tells whether a coordinate is farther than so much from all that lies between two others. */
const isBeyond = (x: number, a: number, b: number, far: number): boolean =>
  Math.min(a, b) - x > far || x - Math.max(a, b) > far;

/** Returns the distance of a place from the segment between two others. */
export function toSegment(x: number, y: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const length = Math.hypot(dx, dy);
  if (length === 0) return Math.hypot(x - ax, y - ay);
  // Along the segment in units of its length, which does not overflow.
  const along = ((x - ax) / length) * (dx / length) + ((y - ay) / length) * (dy / length);
  const t = Math.min(1, Math.max(0, along));
  return Math.hypot(x - (ax + t * dx), y - (ay + t * dy));
}

/** Tells whether there is a segment between two points. */
export function hasSegment(segments: Indices, a: number, b: number): boolean {
  for (let k = 0; k < segments.length; k += 2) {
    const [from, to] = [segments[k], segments[k + 1]];
    if ((from === a && to === b) || (from === b && to === a)) return true;
  }
  return false;
}
