// The dual of a triangulation: the circumcenters of neighbours joined. Where the triangulation is Delaunay, these
// are the borders of the Voronoi cells. Rounded, for drawing.

import type { Coordinates } from "../engine/protocol";
import { circumcircle } from "./circles";
import { type Links, OUTSIDE } from "./links";

export interface Dual {
  /** From x, y to x, y: four numbers each. */
  segments: Float64Array;
  /** From x, y in the direction x, y of length 1: four numbers each. */
  rays: Float64Array;
}

/** Computes the dual. Borders of the hull become rays; those that `isWall` names do not. Linear. */
export function dualOf(points: Coordinates, links: Links, isWall: (h: number) => boolean): Dual {
  const centers = centersOf(points, links);
  const [segments, rays]: [number[], number[]] = [[], []];
  const center = (h: number): [number, number] => {
    const t = Math.floor(h / 3);
    return [centers[2 * t], centers[2 * t + 1]];
  };
  for (let h = 0; h < links.twins.length; h++) {
    const twin = links.twins[h];
    const from = center(h);
    if (Number.isNaN(from[0])) continue;
    if (twin === OUTSIDE) {
      if (!isWall(h)) rays.push(...from, ...outwards(points, links.origin(h), links.dest(h)));
    } else if (twin > h && !Number.isNaN(center(twin)[0])) {
      segments.push(...from, ...center(twin));
    }
  }
  return { segments: Float64Array.from(segments), rays: Float64Array.from(rays) };
}

/** The circumcenters of all triangles; NaN of those that are flat. */
function centersOf(points: Coordinates, { triangles }: Links): Float64Array {
  const centers = new Float64Array((2 * triangles.length) / 3).fill(Number.NaN);
  for (let t = 0; 3 * t < triangles.length; t++) {
    const circle = circumcircle(points, triangles.subarray(3 * t, 3 * t + 3));
    if (circle) centers.set([circle.x, circle.y], 2 * t);
  }
  return centers;
}

/** The direction to the right of an edge. */
function outwards(points: Coordinates, a: number, b: number): [number, number] {
  const [dx, dy] = [points[2 * b] - points[2 * a], points[2 * b + 1] - points[2 * a + 1]];
  const length = Math.hypot(dx, dy) || 1;
  return [dy / length, -dx / length];
}

/** What of a segment lies in a box, by Liang and Barsky (1984): from and to which share of it; null: nothing. */
export function clip(
  [x0, y0, x1, y1]: readonly [number, number, number, number],
  low: readonly [number, number],
  high: readonly [number, number],
): [number, number] | null {
  let [from, to] = [0, 1];
  for (const [start, length, least, most] of [
    [x0, x1 - x0, low[0], high[0]],
    [y0, y1 - y0, low[1], high[1]],
  ]) {
    const [near, far] = [(least - start) / length, (most - start) / length];
    if (length === 0) {
      if (start < least || start > most) return null;
      continue;
    }
    from = Math.max(from, Math.min(near, far));
    to = Math.min(to, Math.max(near, far));
  }
  return from < to ? [from, to] : null;
}
