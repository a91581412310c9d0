// The edges that might be flipped: inner ones that are no constraints, each with the apexes of its two triangles.

import type { Coordinates, Frame } from "../engine/protocol";
import { Picker } from "../stage/picking";

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

const pickers = new WeakMap<Quad[], Picker>();

/** Finds the edge that is nearest to a place, if it is no farther than `radius`. Sorts the edges at the first question. */
export function nearestEdge(
  points: Coordinates,
  quads: Quad[],
  x: number,
  y: number,
  radius: number,
): Quad | null {
  const picker = pickers.get(quads) ?? pickerFor(points, quads);
  pickers.set(quads, picker);
  const found = picker.edge(x, y, radius);
  return found === null ? null : quads[found];
}

function pickerFor(points: Coordinates, quads: Quad[]): Picker {
  const edges = Uint32Array.from(quads.flatMap(({ edge }) => edge));
  return new Picker({ points, edges, triangles: new Uint32Array() });
}
