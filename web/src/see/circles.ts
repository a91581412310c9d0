// Circles, for drawing: rounded. What is decided exactly is decided by the module.

import type { Coordinates } from "../engine/protocol";

export interface Circle {
  x: number;
  y: number;
  radius: number;
}

/** Returns the circle through three vertices; null if they are too nearly on one line to tell. */
export function circumcircle(points: Coordinates, [i, j, k]: Iterable<number>): Circle | null {
  const [ax, ay] = [points[2 * i], points[2 * i + 1]];
  // Relative to a corner: the offset of a map's coordinates does not round the rest away.
  const [bx, by, cx, cy] = [
    points[2 * j] - ax,
    points[2 * j + 1] - ay,
    points[2 * k] - ax,
    points[2 * k + 1] - ay,
  ];
  const double = 2 * (bx * cy - by * cx);
  const [b, c] = [bx * bx + by * by, cx * cx + cy * cy];
  const [x, y] = [(cy * b - by * c) / double, (bx * c - cx * b) / double];
  const circle = { x: ax + x, y: ay + y, radius: Math.hypot(x, y) };
  return Number.isFinite(circle.x) && Number.isFinite(circle.y) ? circle : null;
}

/** Returns the smallest circle through two vertices. */
export function diametral(points: Coordinates, [i, j]: Iterable<number>): Circle {
  const [ax, ay, bx, by] = [points[2 * i], points[2 * i + 1], points[2 * j], points[2 * j + 1]];
  return { x: (ax + bx) / 2, y: (ay + by) / 2, radius: Math.hypot(bx - ax, by - ay) / 2 };
}

/** Where a vertex is for certain; 0: on the circle, as far as rounded numbers tell. */
export type Sign = 1 | 0 | -1;

/** Units in the last place of a number that is about 1. */
const EPSILON = 2 ** -52;

/**
 * Tells whether the vertex `d` lies inside (1) or outside (-1) of the circle through a triangle, counter-clockwise.
 * An answer other than 0 is right: it is larger than all that rounding may have done to it (the bound is a coarse one
 * of the kind of Shewchuk's, 1997).
 */
export function sideOfCircle(points: Coordinates, [a, b, c]: Iterable<number>, d: number): Sign {
  const [x, y] = [points[2 * d], points[2 * d + 1]];
  const [ax, ay] = [points[2 * a] - x, points[2 * a + 1] - y];
  const [bx, by] = [points[2 * b] - x, points[2 * b + 1] - y];
  const [cx, cy] = [points[2 * c] - x, points[2 * c + 1] - y];
  const [a2, b2, c2] = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
  const sum = a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) + c2 * (ax * by - ay * bx);
  const size =
    a2 * (Math.abs(bx * cy) + Math.abs(by * cx)) +
    b2 * (Math.abs(cx * ay) + Math.abs(cy * ax)) +
    c2 * (Math.abs(ax * by) + Math.abs(ay * bx));
  return Math.abs(sum) > 16 * EPSILON * size ? (Math.sign(sum) as Sign) : 0;
}

/** Tells in the same way whether a vertex lies inside of the diametral circle of an edge. */
export function sideOfDiametral(points: Coordinates, [a, b]: Iterable<number>, d: number): Sign {
  const [dx, dy] = [points[2 * d], points[2 * d + 1]];
  const x = (points[2 * a] - dx) * (points[2 * b] - dx);
  const y = (points[2 * a + 1] - dy) * (points[2 * b + 1] - dy);
  const dot = x + y;
  return Math.abs(dot) > 8 * EPSILON * (Math.abs(x) + Math.abs(y)) ? (-Math.sign(dot) as Sign) : 0;
}
