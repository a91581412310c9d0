// The edges that might be flipped: inner ones that are no constraints, each with the apexes of its two triangles.

import type { Coordinates, Frame } from "../engine/protocol";

/** An edge, smaller vertex first, and the apexes on both sides of it. */
export interface Quad {
  edge: [number, number];
  apexes: [number, number];
}

/** Names an edge, whichever way it runs. */
export const keyOf = ([a, b]: readonly [number, number]): string => (a < b ? `${a}–${b}` : `${b}–${a}`);

/** Lists the inner edges that are not locked, by their vertices. Linear, but for the sorting. */
export function innerEdges({
  triangles,
  edges,
  locked,
}: Pick<Frame, "triangles" | "edges" | "locked">): Quad[] {
  const apexes = new Map<string, number[]>();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b, c] = [triangles[t + k], triangles[t + ((k + 1) % 3)], triangles[t + ((k + 2) % 3)]];
      const key = keyOf([a, b]);
      apexes.set(key, [...(apexes.get(key) ?? []), c]);
    }
  }
  const found: Quad[] = [];
  for (let e = 0; e < edges.length; e += 2) {
    const edge = sorted(edges[e], edges[e + 1]);
    const [c, d, ...more] = apexes.get(keyOf(edge)) ?? [];
    const isInner = c !== undefined && d !== undefined && more.length === 0;
    if (isInner && locked[e / 2] === 0) found.push({ edge, apexes: [c, d] });
  }
  return found.sort((a, b) => a.edge[0] - b.edge[0] || a.edge[1] - b.edge[1]);
}

const sorted = (a: number, b: number): [number, number] => (a < b ? [a, b] : [b, a]);

/** Finds the edge that is nearest to a place, if it is nearer than `radius`. Linear. */
export function nearestEdge(
  points: Coordinates,
  quads: Quad[],
  x: number,
  y: number,
  radius: number,
): Quad | null {
  let [nearest, least]: [Quad | null, number] = [null, radius];
  for (const quad of quads) {
    const distance = distanceTo(points, quad.edge, x, y);
    if (distance < least) [nearest, least] = [quad, distance];
  }
  return nearest;
}

/** The distance of a place from an edge: what a pointer means, no decision about topology. */
function distanceTo(points: Coordinates, [a, b]: [number, number], x: number, y: number): number {
  const [ax, ay] = [points[2 * a], points[2 * a + 1]];
  const [dx, dy] = [points[2 * b] - ax, points[2 * b + 1] - ay];
  const along = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1);
  const t = Math.max(0, Math.min(1, along));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
