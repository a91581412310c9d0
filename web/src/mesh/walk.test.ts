import { expect, test } from "vitest";
import { across, edgeToward, insideOf } from "./walk";

// A square, cut from the lower left to the upper right.
const square = {
  points: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1),
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
};

test("an edge leads across and back, the border nowhere", () => {
  expect(across(square, 0, 1)).toBe(1);
  expect(across(square, 1, 2)).toBe(0);
  expect([across(square, 0, 0), across(square, 0, 2)]).toEqual([null, null]);
});

test("a direction means the edge that lies there", () => {
  // Opposite corner 0 is the right side, opposite 1 the diagonal, opposite 2 the bottom.
  expect(edgeToward(square, 0, [1, 0])).toBe(0);
  expect(edgeToward(square, 0, [-1, 0])).toBe(1);
  expect(edgeToward(square, 0, [0, 1])).toBe(1);
  expect(edgeToward(square, 0, [0, -1])).toBe(2);
});

test("the middle lies within, however large numbers are", () => {
  expect(insideOf(square, 0)[0]).toBeCloseTo(2 / 3);
  const large = { ...square, points: square.points.map((x) => x * 1.7e308) };
  expect(insideOf(large, 0).every(Number.isFinite)).toBe(true);
});
