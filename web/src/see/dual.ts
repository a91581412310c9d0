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
  const { twins } = links;
  // Each segment belongs to two half-edges, each ray to one.
  const segments = new Float64Array(2 * twins.length);
  const rays: number[] = [];
  let count = 0;
  for (let h = 0; h < twins.length; h++) {
    const t = 2 * Math.floor(h / 3);
    const [x, y] = [centers[t], centers[t + 1]];
    if (Number.isNaN(x)) continue;
    if (twins[h] === OUTSIDE) {
      if (!isWall(h)) rays.push(x, y, ...outwards(points, links.origin(h), links.dest(h)));
      continue;
    }
    const beyond = 2 * Math.floor(twins[h] / 3);
    if (twins[h] < h || Number.isNaN(centers[beyond])) continue;
    segments.set([x, y, centers[beyond], centers[beyond + 1]], count);
    count += 4;
  }
  return { segments: segments.slice(0, count), rays: Float64Array.from(rays) };
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
