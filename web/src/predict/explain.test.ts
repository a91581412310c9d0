import { expect, test } from "vitest";
import type { Answered, Puzzle, Reason } from "../state/predict";
import { predict as say } from "../words/en/predict";
import { explain } from "./explain";

const answer = { edge: [3, 7], apexes: [1, 9] } as Reason["quad"];
const guess = { edge: [0, 4], apexes: [5, 6] } as Reason["quad"];
const puzzle = { answer, isByCircle: true, before: "Vertex 3 lies to the left." } as Puzzle;
const told = (because: Partial<Reason>, instead: Partial<Reason> | null): Answered =>
  ({
    guess,
    verdict: instead ? "wrong" : "right",
    because: { quad: answer, ...because },
    instead: instead && { quad: guess, ...instead },
  }) as Answered;

test("the reason is the exact sign of the test", () => {
  const inside = explain(told({ side: "inside", counts: "inside" }, null), puzzle, say);
  expect(inside).toBe(
    "Edge 3–7 is flipped to 1–9: vertex 9 lies inside the circle through 3–7 and 1, so the edge is not locally Delaunay.",
  );
  expect(explain(told({ side: "on", counts: "inside" }, null), puzzle, say)).toContain("exactly on");
});

test("where a sweep closes a dent, no circle is the reason, inside or not", () => {
  const dent = { ...puzzle, isByCircle: false };
  const said = explain({ ...told({}, null), because: null }, dent, say);
  expect(said).toContain("is flipped to 1–9. Vertex 3 lies to the left.");
  expect(said).not.toContain("locally Delaunay");
});

test("a wrong guess is told why its edge stays", () => {
  const because = { side: "inside", counts: "inside" } as const;
  expect(explain(told(because, { side: "outside", counts: "outside" }), puzzle, say)).toContain(
    "Edge 0–4 is locally Delaunay: vertex 6 lies outside the circle through it and 5.",
  );
  expect(explain(told(because, { side: "on", counts: "outside" }), puzzle, say)).toContain("may stay");
});
