import { expect, test } from "vitest";
import { extent, pathOf, valueAt } from "./chart";

const samples = Float64Array.of(2, 10, 5, 30, 9, 20);

test("a value holds until the next one", () => {
  expect([0, 1, 2, 4, 5, 8, 9, 100].map((at) => valueAt(samples, at))).toEqual([
    undefined,
    undefined,
    10,
    10,
    30,
    30,
    20,
    20,
  ]);
  expect(valueAt(new Float64Array(), 3)).toBeUndefined();
});

test("curves are stairs from bottom to top of their box, up to the end", () => {
  expect(extent(samples)).toEqual([10, 30]);
  expect(pathOf(samples, 10, 100, 40)).toBe("M20 40H50V0H90V20H100");
  expect(pathOf(Float64Array.of(0, 5), 10, 100, 40)).toBe("M0 40H100");
  expect(pathOf(new Float64Array(), 10, 100, 40)).toBe("");
});
