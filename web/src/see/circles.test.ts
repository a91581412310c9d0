import { expect, test } from "vitest";
import { circumcircle, diametral, sideOfCircle, sideOfDiametral } from "./circles";

const points = Float64Array.of(0, 0, 2, 0, 0, 2, 2, 2, 1, 1, 5, 5);

test("circles go through their vertices", () => {
  const { x, y, radius } = circumcircle(points, [0, 1, 2])!;
  expect([x, y, radius]).toEqual([1, 1, Math.SQRT2]);
  expect(diametral(points, [0, 1])).toEqual({ x: 1, y: 0, radius: 1 });
  expect(circumcircle(points, [0, 4, 5])).toBeNull();
});

test("an offset does not matter", () => {
  const far = points.map((value, i) => value / 1024 + (i % 2 === 0 ? 5e6 : 4e5));
  const { x, y } = circumcircle(far, [0, 1, 2])!;
  expect([x, y]).toEqual([5e6 + 1 / 1024, 4e5 + 1 / 1024]);
});

test("sides are told only when they are certain", () => {
  expect(sideOfCircle(points, [0, 1, 2], 4)).toBe(1);
  expect(sideOfCircle(points, [0, 1, 2], 5)).toBe(-1);
  expect(sideOfCircle(points, [0, 1, 2], 3)).toBe(0);
  const nearly = points.slice();
  nearly[6] = 2 - 2 ** -51;
  expect(sideOfCircle(nearly, [0, 1, 2], 3)).not.toBe(-1);
  expect(sideOfDiametral(points, [0, 3], 4)).toBe(1);
  expect(sideOfDiametral(points, [0, 3], 1)).toBe(0);
  expect(sideOfDiametral(points, [0, 1], 5)).toBe(-1);
});
