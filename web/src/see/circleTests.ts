// The last test of a circle among what has happened, and who decides where there is a tie.

import type { Coordinates, Happening } from "../engine/protocol";

/** What comes after a test, beside what follows from it. */
const others = new Set(["edge-examined", "popped", "point-considered", "triangle-considered", "stage-ended"]);

/** A test of a circle, as a run tells it. */
export interface CircleTest {
  triangle: [number, number, number];
  point: number;
  answer: "inside" | "on" | "outside";
  is_inside: boolean;
}

/** Finds the last test of a circle, as long as nothing else is looked at since. */
export function lastTest(happenings: readonly Happening[]): CircleTest | null {
  const last = happenings.findLast(({ kind }) => kind === "circle-tested" || others.has(kind));
  return last?.kind === "circle-tested" ? (last.event as unknown as CircleTest) : null;
}

/**
 * Returns the largest of cocircular vertices, by x and then by y. The perturbation lifts it most: of the two diagonals
 * the one that avoids it stays.
 */
export function largest(points: Coordinates, vertices: number[]): number {
  const byPlace = (v: number, w: number) =>
    points[2 * w] - points[2 * v] || points[2 * w + 1] - points[2 * v + 1];
  return vertices.toSorted(byPlace)[0];
}
