import { expect, test } from "vitest";
import type { Quality } from "../engine/protocol";
import { outcomeOf } from "./outcome";

const of = (change: Partial<Quality>) =>
  outcomeOf({ quality: { outcome: "complete", triangles: 5, unmet: 0, unexcused: 0, ...change } as Quality });

test("what came of it has a name and a tone", () => {
  expect(of({})).toEqual({ name: "complete", tone: "good" });
  expect(of({ unmet: 2 })).toEqual({ name: "excused", tone: "fair" });
  expect(of({ unmet: 2, unexcused: 1 })).toEqual({ name: "unexcused", tone: "bad" });
  expect(of({ outcome: "budgetExhausted", unmet: 2, unexcused: 2 })).toEqual({
    name: "budgetExhausted",
    tone: "bad",
  });
  expect(of({ outcome: null })).toEqual({ name: "made", tone: "good" });
  expect(of({ outcome: null, constrainedEdges: 4 })).toEqual({ name: "constrained", tone: "good" });
  expect(of({ triangles: 0 })).toEqual({ name: "none", tone: "bad" });
});
