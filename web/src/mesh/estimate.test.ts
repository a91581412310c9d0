import { expect, test } from "vitest";
import { estimate, suggestions } from "./estimate";

const square = { points: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1) };

test("the estimate is near what comes of a square", () => {
  // Counted by the library.
  const known = [
    [{ maxEdge: 0.02 }, 6992],
    [{ maxEdge: 0.005, minAngle: 25 }, 104837],
    [{ maxArea: 1e-3, minAngle: 25 }, 1102],
    [{ maxArea: 1e-4, minAngle: 25 }, 10488],
  ] as const;
  for (const [options, triangles] of known) {
    const told = estimate(square, 1, "refine", options)! / triangles;
    expect(told).toBeGreaterThan(0.9);
    expect(told).toBeLessThan(1.1);
  }
});

test("the smaller of two sizes counts, and angles alone tell nothing", () => {
  const both = estimate(square, 1, "refine", { maxEdge: 0.5, maxArea: 1e-4 });
  expect(both).toBe(estimate(square, 1, "refine", { maxArea: 1e-4 }));
  expect(estimate(square, 1, "refine", { minAngle: 30 })).toBeNull();
  expect(estimate({ points: new Float64Array(200) }, 1, "triangulate", {})).toBe(198);
  expect(estimate(square, 1, "refine", { maxEdge: 1e-300 })).toBeGreaterThan(1e300);
});

test("suggestions fit the drawing, and there always are some", () => {
  expect(suggestions(Float64Array.of(0, 0, 40, 0)).maxEdge).toBe(1);
  expect(suggestions(new Float64Array()).maxEdge).toBeGreaterThan(0);
  expect(suggestions(Float64Array.of(-1e308, -1e308, 1e308, 1e308)).maxEdge).toBeGreaterThan(0);
});
