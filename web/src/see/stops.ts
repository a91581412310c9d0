// The stops of a walk, or of a search, among what has happened.

import type { Happening } from "../engine/protocol";

/** A place of a walk: the vertices of a triangle or of an edge. */
export interface Stop {
  vertices: number[];
  /** Whether the walk has come here from the place before; or else this one is looked at for another reason. */
  isLinked: boolean;
}

const steps = new Set(["walk-stepped", "triangle-visited"]);

/** With these something is made of what the walk has found: it is over, and would only hide what comes. */
const works = new Set([
  "edge-created",
  "edge-deleted",
  "triangle-created",
  "triangle-deleted",
  "vertex-created",
  "edge-flipped",
]);

/** Returns the steps of the walk that is under way, or has just come to its end; none if it is over. */
export function walkOf(happenings: readonly Happening[]): Happening[] {
  const last = happenings.findLast(({ kind }) => steps.has(kind) || works.has(kind));
  return last && steps.has(last.kind) ? happenings.filter(({ kind }) => steps.has(kind)) : [];
}

/** Takes the stops of the walk out of what has happened. */
export function stopsOf(happenings: readonly Happening[]): Stop[] {
  const stops: Stop[] = [];
  for (const { event } of happenings) {
    const vertices = (event.triangle ?? event.edge) as number[];
    const before = stops.at(-1);
    stops.push({ vertices, isLinked: before !== undefined && touch(before.vertices, vertices) });
  }
  return stops;
}

/** Tells whether places follow upon each other: two triangles by a common edge, two edges of a triangle by a vertex. */
function touch(before: number[], after: number[]): boolean {
  const common = after.filter((v) => before.includes(v)).length;
  return common >= Math.min(before.length, after.length, 3) - (before.length === after.length ? 1 : 0);
}

/** Tells a walk, which goes from neighbour to neighbour, from a search, which goes everywhere. */
export function isPath(stops: readonly Stop[]): boolean {
  return 2 * stops.filter(({ isLinked }) => isLinked).length >= stops.length;
}
