import { expect, test } from "vitest";
import { arcBetween } from "./arms";

// Two segments from the origin, with 45 degrees between them; the first goes on to the other side.
const drawn = {
  points: Float64Array.of(-2, 0, 2, 0, 0, 0, 1, 1),
  segments: Uint32Array.of(0, 1, 2, 3),
};

test("the arc joins the arms that have so many degrees between them", () => {
  const arc = arcBetween(drawn, 2, [0, 1], 45, 1)!;
  expect(arc[0][0]).toBeCloseTo(1);
  expect(arc.at(-1)![1]).toBeCloseTo(Math.SQRT1_2);
  expect(arc.every(([x, y]) => Math.abs(Math.hypot(x, y) - 1) < 1e-9)).toBe(true);
  const other = arcBetween(drawn, 2, [0, 1], 135, 1)!;
  expect(other[0][0]).toBeCloseTo(-1);
  expect(arcBetween(drawn, 2, [0, 1], 20, 1)).toBeNull();
});
