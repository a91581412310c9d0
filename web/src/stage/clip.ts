// Cutting lines and polygons off at a box, so that no canvas gets numbers that it would round by more than a pixel.

import type { Box } from "./camera";

export type Spot = readonly [number, number];

/** Returns the part of a line within a box; null if there is none. After Liang and Barsky. */
export function clipLine(from: Spot, to: Spot, { low, high }: Box): [Spot, Spot] | null {
  let [first, last] = [0, 1];
  for (const axis of [0, 1] as const) {
    const way = to[axis] - from[axis];
    const [enter, leave] = [low[axis] - from[axis], high[axis] - from[axis]];
    if (way === 0) {
      if (enter > 0 || leave < 0) return null;
      continue;
    }
    first = Math.max(first, Math.min(enter / way, leave / way));
    last = Math.min(last, Math.max(enter / way, leave / way));
  }
  if (first > last) return null;
  return [first > 0 ? between(from, to, first) : from, last < 1 ? between(from, to, last) : to];
}

/** Returns the part of a polygon within a box; empty if there is none. After Sutherland and Hodgman. */
export function clipPolygon(corners: readonly Spot[], { low, high }: Box): readonly Spot[] {
  let rest = corners;
  for (const axis of [0, 1] as const) {
    rest = cut(rest, axis, low[axis], 1);
    rest = cut(rest, axis, high[axis], -1);
  }
  return rest;
}

/** Keeps what lies at or behind a value of one coordinate, in the direction of `sign`. */
function cut(corners: readonly Spot[], axis: 0 | 1, at: number, sign: 1 | -1): Spot[] {
  const kept: Spot[] = [];
  for (let k = 0; k < corners.length; k++) {
    const [from, to] = [corners[k], corners[(k + 1) % corners.length]];
    const [a, b] = [sign * (from[axis] - at), sign * (to[axis] - at)];
    if (a >= 0) kept.push(from);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push(between(from, to, a / (a - b)));
  }
  return kept;
}

/** Counted from the end that is nearer: the other one may be far away. */
function between(from: Spot, to: Spot, part: number): Spot {
  const [x, y] = [to[0] - from[0], to[1] - from[1]];
  return part <= 0.5
    ? [from[0] + part * x, from[1] + part * y]
    : [to[0] - (1 - part) * x, to[1] - (1 - part) * y];
}
