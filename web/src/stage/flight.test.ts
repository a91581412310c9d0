// The way from one view to another.

import { expect, test } from "vitest";
import { toScreen, zoom } from "./camera";
import { between, canFollow } from "./flight";

const size = { width: 800, height: 600 };
const from = { x: 3, y: 4, scale: 10 };

test("a flight begins and ends where it should", () => {
  const to = { x: 7, y: 1, scale: 50 };
  expect(between(from, to, 0)).toEqual(from);
  expect(between(from, to, 1)).toEqual(to);
  expect(between(from, { ...from, x: 13 }, 0.25)).toEqual({ ...from, x: 5.5 });
});

test("on the way the place under the pointer stays there", () => {
  const to = zoom(from, size, 8, 100, 500);
  const place = [from.x - 30, from.y - 20] as const;
  for (const part of [0.2, 0.5, 0.9]) {
    const [px, py] = toScreen(between(from, to, part), size, ...place);
    expect(px).toBeCloseTo(100);
    expect(py).toBeCloseTo(500);
  }
});

test("what has nothing in common is not flown to", () => {
  expect(canFollow(from, { x: 3, y: 4, scale: 20 }, size)).toBe(true);
  expect(canFollow(from, { x: 3, y: 4, scale: 1e9 }, size)).toBe(false);
  expect(canFollow(from, { x: 5e6, y: 4, scale: 10 }, size)).toBe(false);
});
