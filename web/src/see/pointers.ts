// Where the pointers of a half-edge lead: the algebra of a mesh.

import { type Links, next, OUTSIDE, previous } from "./links";

/** The half-edge itself, the one back, and those that follow and precede it about triangle and origin. */
export const pointers = ["h", "twin", "next", "prev", "onext", "oprev"] as const;
export type Pointer = (typeof pointers)[number];

/** Directed edges, from one vertex to another. */
export type Pointers = Partial<Record<Pointer, [from: number, to: number]>>;

/** Says where the pointers of the half-edge between two vertices lead; those that lead outside are missing. */
export function pointersOf(links: Links, from: number, to: number): Pointers {
  const [h, twin] = [links.find(from, to), links.find(to, from)];
  const ends = (e: number): [number, number] => [links.origin(e), links.dest(e)];
  const found: Pointers = { h: [from, to], twin: [to, from] };
  if (h !== OUTSIDE) {
    found.next = ends(next(h));
    found.prev = ends(previous(h));
    // About the origin, counter-clockwise: the edge before, backwards.
    found.onext = [from, links.apex(h)];
  }
  // And clockwise: what follows the twin.
  if (twin !== OUTSIDE) found.oprev = ends(next(twin));
  return found;
}
