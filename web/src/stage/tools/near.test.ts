import { expect, test } from "vitest";
import { hasSegment, nearestPoint, nearestSegment, toSegment } from "./near";

const points = Float64Array.of(0, 0, 4, 0, 4, 3, 4, 3);

test("the nearest point within a radius, the first of equals", () => {
  expect(nearestPoint(points, 3.9, 2.9, 1)).toBe(2);
  expect(nearestPoint(points, 2, 0, 2)).toBe(0);
  expect(nearestPoint(points, 2, 1.5, 1)).toBe(null);
  expect(nearestPoint(new Float64Array(), 0, 0, 9)).toBe(null);
});

test("the nearest segment, between its ends and beyond them", () => {
  const segments = Uint32Array.of(0, 1, 1, 2);
  expect(nearestSegment(points, segments, 2, 0.5, 1)).toBe(0);
  expect(nearestSegment(points, segments, 4.5, 2, 1)).toBe(1);
  expect(nearestSegment(points, segments, 2, 2, 1)).toBe(null);
  expect(toSegment(-3, 4, 0, 0, 4, 0)).toBe(5);
  expect(toSegment(3, 4, 0, 0, 0, 0)).toBe(5);
});

test("distances of huge and of tiny segments are numbers", () => {
  expect(toSegment(0, 1e300, -1e300, 0, 1e300, 0)).toBe(1e300);
  expect(toSegment(0, 1e-300, -1e-300, 0, 1e-300, 0)).toBe(1e-300);
});

test("a segment is the same both ways", () => {
  const segments = Uint32Array.of(0, 1, 5, 2);
  expect(hasSegment(segments, 2, 5)).toBe(true);
  expect(hasSegment(segments, 1, 5)).toBe(false);
});
