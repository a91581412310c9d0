import { expect, test } from "vitest";
import { along, axisOf, barOf, count, goodness, valueAt } from "./axis";

test("every value counts in one bar, the ends included", () => {
  const values = Float32Array.of(0, 1.9, 2, 59.99, 60);
  const axis = axisOf("minAngle", values);
  expect(count(axis, values).reduce((a, b) => a + b)).toBe(5);
  expect([...values].map((value) => barOf(axis, value))).toEqual([0, 0, 1, 29, 29]);
});

test("sizes go by factors, and back again", () => {
  const axis = axisOf("area", Float32Array.of(1, 100, 10000));
  expect(axis.isLogarithmic).toBe(true);
  expect(along(axis, 100)).toBeCloseTo(0.5);
  expect(valueAt(axis, 0.25)).toBeCloseTo(10);
});

test("there is an axis where all values are the same, or none is there", () => {
  for (const values of [Float32Array.of(3, 3), new Float32Array(), Float32Array.of(0, 0)]) {
    const axis = axisOf("area", values);
    expect(axis.bars).toBe(1);
    expect(count(axis, values)).toEqual([values.length]);
    expect(goodness(axis, 3)).toBe(0);
  }
});

test("large angles are bad, and each region has a bar", () => {
  const angles = axisOf("maxAngle", Float32Array.of(70));
  expect([goodness(angles, 60), goodness(angles, 180)]).toEqual([1, 0]);
  const regions = Float32Array.of(-1, 0, 1, 1);
  expect(count(axisOf("region", regions), regions)).toEqual([1, 1, 2]);
});
