// The rules of a race: how the clock runs, and who was first.

import type { Algorithm, Clock, Run, Tally } from "../engine/protocol";

/** What a run needs from its beginning to its end, in each unit; null: nobody knows. */
export type Totals = Record<Clock, number | null>;

/** Returns how far the clock must go until all have come to their end. */
export function fullTime(all: Totals[], clock: Clock): number {
  return all.reduce((most, totals) => Math.max(most, totals[clock] ?? 0), 0);
}

/** Returns where the clock stands after some seconds more; the whole race takes `duration` seconds. */
export function advance(amount: number, full: number, seconds: number, duration: number): number {
  return Math.min(full, amount + (full * seconds) / duration);
}

/** Returns the place of each: who needs least is first; who needs as much shares a place. */
export function places(all: Totals[], clock: Clock): number[] {
  const need = all.map((totals) => totals[clock] ?? Number.POSITIVE_INFINITY);
  return need.map((mine) => 1 + need.filter((other) => other < mine).length);
}

/**
 * Tells whether all have come to the same triangles; and if not, but those agree who make the Delaunay triangulation
 * of the points, who of them is not meant to.
 */
export function agreement<R extends Pick<Run, "algorithm" | "hash">>(
  runs: R[],
  algorithms: Pick<Algorithm, "name" | "delaunay" | "takes">[],
): { agree: boolean; byDesign: R[] } {
  const areSame = (some: R[]) => some.every(({ hash }) => hash === some[0].hash);
  if (areSame(runs)) return { agree: true, byDesign: [] };
  // Domains are refined, or carved: that is another set of triangles, too.
  const isMeant = ({ algorithm }: R) =>
    algorithms.some(({ name, delaunay, takes }) => name === algorithm && delaunay && takes !== "domain");
  return { agree: false, byDesign: areSame(runs.filter(isMeant)) ? runs.filter((run) => !isMeant(run)) : [] };
}

/** Counts all tests that predicates have decided. */
export const testsOf = ({ orientationTests, circleTests }: Tally): number => orientationTests + circleTests;

/** Racers to begin with: different ways to the same triangulation. */
export const usual = ["incremental", "divide-and-conquer", "sweep-circle"];

/** So many race at once. */
export const [FEWEST, MOST] = [2, 3];

/** Changes one of the racers; whoever has been chosen twice changes places. */
export function withRacer(racers: string[], lane: number, name: string): string[] {
  const next = [...racers];
  const there = racers.indexOf(name);
  if (there >= 0) next[there] = racers[lane];
  next[lane] = name;
  return next;
}
