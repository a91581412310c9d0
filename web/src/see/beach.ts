// Fortune's beach line: what is as far from a site above the sweep line as from the line is a parabola; the beach
// line consists of the lowest arcs. Rounded, for drawing; which arcs there are, the run says.

import type { Coordinates } from "../engine/protocol";

/** A part of the beach line: the arc of a site between two abscissas. */
export interface Arc {
  site: number;
  left: number;
  right: number;
}

/** Returns the height of the parabola of a site over an abscissa. */
export function heightAt(x: number, px: number, py: number, line: number): number {
  const double = 2 * (py - line);
  return ((x - px) * (x - px)) / double + (py + line) / 2;
}

/** Returns where the arc of `p` ends and that of `q`, on its right, begins. */
export function breakpoint(points: Coordinates, p: number, q: number, line: number): number {
  const [px, py, qx, qy] = [points[2 * p], points[2 * p + 1], points[2 * q], points[2 * q + 1]];
  // A site on the line has no arc yet, only a ray straight up.
  if (py === line) return px;
  if (qy === line) return qx;
  if (py === qy) return (px + qx) / 2;
  const [u, v] = [1 / (2 * (py - line)), 1 / (2 * (qy - line))];
  const a = u - v;
  const b = 2 * (qx * v - px * u);
  const c = px * px * u - qx * qx * v + (py - qy) / 2;
  return (-b + Math.sqrt(Math.max(0, b * b - 4 * a * c))) / (2 * a);
}

/** Cuts the beach line into its arcs, from left to right; the outer ones end at `low` and `high`. */
export function arcsOf(
  points: Coordinates,
  front: ArrayLike<number>,
  line: number,
  low: number,
  high: number,
): Arc[] {
  const arcs: Arc[] = [];
  let left = low;
  for (let i = 0; i < front.length; i++) {
    const isLast = i + 1 === front.length;
    const right = isLast ? high : breakpoint(points, front[i], front[i + 1], line);
    arcs.push({ site: front[i], left, right: Math.max(left, right) });
    left = Math.max(left, right);
  }
  return arcs;
}
