// What is cut off, and what stays.

import { expect, test } from "vitest";
import { arc } from "./arc";
import { clipLine, clipPolygon, type Spot } from "./clip";

const box = { low: [0, 0], high: [10, 10] } as const;

test("lines are cut at the box", () => {
  expect(clipLine([2, 2], [8, 3], box)).toEqual([
    [2, 2],
    [8, 3],
  ]);
  expect(clipLine([-10, 5], [30, 5], box)).toEqual([
    [0, 5],
    [10, 5],
  ]);
  expect(clipLine([-1, 5], [-3, 8], box)).toBeNull();
  expect(clipLine([-5, 4], [4, -5], box)).toBeNull();
  expect(clipLine([3, -4], [3, 40], box)).toEqual([
    [3, 0],
    [3, 10],
  ]);
  expect(clipLine([11, 0], [11, 9], box)).toBeNull();
});

test("lines that come from far away are cut where they enter", () => {
  const [from, to] = clipLine([-1e15, -1e15 + 3], [1e15, 1e15 + 3], box)!;
  expect(from[1] - from[0]).toBeCloseTo(3, 0);
  expect(to[1] - to[0]).toBeCloseTo(3, 0);
});

test.each([
  ["within", 32, [1, 1, 9, 1, 1, 9]],
  ["all around", 100, [-100, -100, 300, -100, -100, 300]],
  ["at a corner", 25, [5, 5, 25, 5, 5, 25]],
  ["outside", 0, [11, 0, 15, 0, 11, 9]],
])("polygons are cut at the box: %s", (_, left, [ax, ay, bx, by, cx, cy]) => {
  const piece = clipPolygon(
    [
      [ax, ay],
      [bx, by],
      [cx, cy],
    ] as Spot[],
    box,
  );
  expect(area(piece)).toBeCloseTo(left);
});

test("huge circles pass where they should", () => {
  const radius = 1e9;
  const { rim, inside } = arc([5, 5 - radius], radius, box);
  for (const [x, y] of rim) expect(Math.abs(y - 5 + (x - 5) ** 2 / (2 * radius))).toBeLessThan(1e-6);
  // The lower half of the box is inside.
  expect(area(clipPolygon([...rim, ...inside], box))).toBeCloseTo(50, 3);
  expect(area(clipPolygon(filled([5, 1e6 - radius], radius), box))).toBeCloseTo(100, 3);
  expect(filled([5, -1e6 - radius], radius)).toEqual([]);
});

function filled(center: Spot, radius: number): Spot[] {
  const { rim, inside } = arc(center, radius, box);
  return [...rim, ...inside];
}

function area(corners: readonly Spot[]): number {
  let twice = 0;
  for (let k = 0; k < corners.length; k++) {
    const [[ax, ay], [bx, by]] = [corners[k], corners[(k + 1) % corners.length]];
    twice += ax * by - ay * bx;
  }
  return Math.abs(twice / 2);
}
