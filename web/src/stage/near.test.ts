// What is cut out of a scene.

import { expect, test } from "vitest";
import { isWithin, near, windowOf } from "./near";
import type { StageScene } from "./scene";

const scene: StageScene = {
  points: Float64Array.of(500_000, 5_400_000, 500_100, 5_400_000, 500_000, 5_400_100, 500_100, 5_400_100),
  edges: Uint32Array.of(0, 1, 1, 2, 2, 3),
  locked: Uint8Array.of(1, 0, 0),
  triangles: Uint32Array.of(0, 1, 2, 1, 3, 2),
  values: Float32Array.of(0.25, 0.75),
  hasDots: true,
};

test("around a vertex there are its edges, its triangle and itself", () => {
  const part = near(scene, { x: 500_000, y: 5_400_000, unit: 2 ** -20 }).scene;
  expect([...part.points.slice(2 * part.dotsFrom!)]).toEqual([0, 0]);
  expect([...part.locked!]).toEqual([1]);
  expect([...part.points.slice(2 * part.edges[0], 2 * part.edges[1] + 2)]).toEqual([0, 0, 1, 0]);
  expect([...part.values!].every((value) => value === 0.25)).toBe(true);
  expect(area(part)).toBeCloseTo(1);
});

test("in the middle of the diagonal there are two triangles", () => {
  const part = near(scene, { x: 500_050, y: 5_400_050, unit: 1e-3 }).scene;
  expect(part.edges.length).toBe(2);
  expect(new Set(part.values)).toEqual(new Set([0.25, 0.75]));
  expect(area(part)).toBeCloseTo(4);
});

test("elsewhere there is nothing", () => {
  const part = near(scene, { x: 600_000, y: 5_400_050, unit: 1 }).scene;
  expect(part.points.length + part.edges.length + part.triangles.length).toBe(0);
});

test("a window holds its view and some more", () => {
  const size = { width: 800, height: 600 };
  const camera = { x: 3, y: 4, scale: 1e6 };
  const window = windowOf(camera, size);
  expect(isWithin(camera, size, window)).toBe(true);
  expect(isWithin({ ...camera, x: 3 + 300e-6 }, size, window)).toBe(true);
  expect(isWithin({ ...camera, x: 3 + 900e-6 }, size, window)).toBe(false);
  expect(isWithin({ ...camera, scale: 2e5 }, size, window)).toBe(false);
});

function area({ points, triangles }: StageScene): number {
  let twice = 0;
  for (let k = 0; k < triangles.length; k += 3) {
    const [a, b, c] = [...triangles.slice(k, k + 3)].map((v) => [points[2 * v], points[2 * v + 1]]);
    twice += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  return twice / 2;
}
