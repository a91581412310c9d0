import { expect, test } from "vitest";
import { bars, INSET, pixelOf, positionAt } from "./strip";

test("pixels and positions belong together, with the ends under the thumb", () => {
  expect(pixelOf(0, 50, 500)).toBe(INSET);
  expect(pixelOf(50, 50, 500)).toBe(500 - INSET);
  for (const position of [0, 1, 17, 49, 50])
    expect(positionAt(pixelOf(position, 50, 500), 50, 500)).toBe(position);
  expect(positionAt(-20, 50, 500)).toBe(0);
  expect(positionAt(900, 50, 500)).toBe(50);
  expect(pixelOf(0, 0, 500)).toBe(INSET);
  expect(positionAt(100, 0, 500)).toBe(0);
  expect(positionAt(100, 10, 0)).toBe(10);
});

test("bars stand where something happens, the highest up to the top", () => {
  expect(bars([0, 4, 0, 1])).toEqual([
    { from: 0.25, to: 0.5, height: 1 },
    { from: 0.75, to: 1, height: 0.5 },
  ]);
  expect(bars([])).toEqual([]);
  expect(bars([0, 0])).toEqual([]);
});
