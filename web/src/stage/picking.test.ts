// Picking, compared with looking at everything.

import { expect, test } from "vitest";
import { Picker, pickerOf } from "./picking";
import type { StageScene } from "./scene";

/** Numbers from 0 to 1 that are the same every time. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

/** A grid of shaken points, or of points that crowd in one corner; scaled, and far from the origin. */
function grid(n: number, unit: number, at: number, isCrowded: boolean): StageScene {
  const next = random(n);
  const points = new Float64Array(2 * n * n);
  for (let i = 0; i < n * n; i++) {
    for (const [axis, whole] of [i % n, Math.floor(i / n)].entries()) {
      const part = (whole + 0.4 * next()) / n;
      points[2 * i + axis] = at + unit * (isCrowded ? part ** 8 : part);
    }
  }
  const [triangles, edges]: [number[], number[]] = [[], []];
  for (let i = 0; i < n * (n - 1); i++) {
    if (i % n === n - 1) continue;
    triangles.push(i, i + 1, i + n, i + 1, i + n + 1, i + n);
    edges.push(i, i + 1, i, i + n, i + 1, i + n);
  }
  return {
    points,
    edges: Uint32Array.from(edges),
    locked: null,
    triangles: Uint32Array.from(triangles),
    values: null,
    hasDots: false,
  };
}

function bruteVertex({ points }: StageScene, x: number, y: number, radius: number): number | null {
  let [found, least]: [number | null, number] = [null, radius];
  for (let v = 0; 2 * v < points.length; v++) {
    const far = Math.hypot(points[2 * v] - x, points[2 * v + 1] - y);
    if (far < least || (far === least && found === null)) [found, least] = [v, far];
  }
  return found;
}

/** The distance of an edge. */
function farFrom({ points, edges }: StageScene, edge: number, x: number, y: number): number {
  const [a, b] = [2 * edges[2 * edge], 2 * edges[2 * edge + 1]];
  const [dx, dy] = [points[b] - points[a], points[b + 1] - points[a + 1]];
  const length = Math.hypot(dx, dy);
  const along = ((x - points[a]) / length) * (dx / length) + ((y - points[a + 1]) / length) * (dy / length);
  const part = Math.max(0, Math.min(along, 1));
  return Math.hypot(points[a] + part * dx - x, points[a + 1] + part * dy - y);
}

const scenes: [string, number, number, boolean][] = [
  ["even", 1, 0, false],
  ["crowded", 1, 0, true],
  ["UTM", 1000, 5_400_000, false],
  ["small", 1e-300, 0, false],
  ["large", 1e300, 0, false],
];

test.each(scenes)("%s: as whoever looks at everything", (_, unit, at, isCrowded) => {
  const scene = grid(30, unit, at, isCrowded);
  const picker = new Picker(scene);
  const next = random(7);
  for (let k = 0; k < 300; k++) {
    const [x, y] = [at + unit * next() ** (isCrowded ? 8 : 1), at + unit * next() ** (isCrowded ? 8 : 1)];
    const radius = unit * 0.05 * next();
    expect(picker.vertex(x, y, radius)).toBe(bruteVertex(scene, x, y, radius));
    const edge = picker.edge(x, y, radius);
    const fars = Array.from({ length: scene.edges.length / 2 }, (_, e) => farFrom(scene, e, x, y));
    const least = Math.min(...fars);
    if (edge === null) expect(least).toBeGreaterThan(0.999 * radius);
    else expect(fars[edge]).toBeLessThanOrEqual(least + 1e-9 * unit);
    const triangle = picker.triangle(x, y);
    if (triangle !== null) expect(weights(scene, triangle, x, y).every((each) => each > -1e-6)).toBe(true);
    else expect(isInAny(scene, x, y)).toBe(false);
  }
});

/** Barycentric coordinates. */
function weights({ points, triangles }: StageScene, t: number, x: number, y: number): number[] {
  const corner = (k: number) => 2 * triangles[3 * t + (k % 3)];
  const [ax, ay] = [points[corner(0)], points[corner(0) + 1]];
  const unit = Math.max(Math.abs(points[corner(1)] - ax), Math.abs(points[corner(1) + 1] - ay));
  const way = (k: number) => [(points[corner(k)] - ax) / unit, (points[corner(k) + 1] - ay) / unit];
  const [[bx, by], [cx, cy], [px, py]] = [way(1), way(2), [(x - ax) / unit, (y - ay) / unit]];
  const area = bx * cy - by * cx;
  const [b, c] = [(px * cy - py * cx) / area, (bx * py - by * px) / area];
  return [1 - b - c, b, c];
}

function isInAny(scene: StageScene, x: number, y: number): boolean {
  for (let t = 0; 3 * t < scene.triangles.length; t++) {
    if (weights(scene, t, x, y).every((each) => each > 1e-9)) return true;
  }
  return false;
}

test("on a shared edge the first triangle, on a shared place the first vertex", () => {
  const scene: StageScene = {
    points: Float64Array.of(0, 0, 1, 0, 0, 1, 1, 1, 1, 1),
    edges: Uint32Array.of(1, 2, 2, 1),
    locked: null,
    triangles: Uint32Array.of(1, 3, 2, 0, 1, 2),
    values: null,
    hasDots: false,
  };
  const picker = new Picker(scene);
  expect(picker.triangle(0.5, 0.5)).toBe(0);
  expect(picker.vertex(1, 1, 0.1)).toBe(3);
  expect(picker.edge(0.6, 0.6, 0.2)).toBe(0);
  expect(picker.edge(0.6, 0.6, 0.1)).toBeNull();
});

test("nothing is found in nothing", () => {
  const none = new Uint32Array();
  const empty = {
    points: new Float64Array(),
    edges: none,
    locked: null,
    triangles: none,
    values: null,
    hasDots: true,
  };
  const picker = new Picker(empty);
  expect([picker.vertex(0, 0, 1), picker.edge(0, 0, 1), picker.triangle(0, 0)]).toEqual([null, null, null]);
});

test("a picker lasts as long as its lists", () => {
  const scene = grid(3, 1, 0, false);
  const recoloured: StageScene = { ...scene, values: new Float32Array(8) };
  expect(pickerOf(scene)).toBe(pickerOf(recoloured));
  expect(pickerOf(scene)).not.toBe(pickerOf({ ...scene, edges: scene.edges.slice() }));
});

test("many points in one place, and one elsewhere, are no trouble", () => {
  const points = new Float64Array(200_000).fill(1);
  points[199_998] = 5;
  const picker = new Picker({ ...grid(2, 1, 0, false), points });
  expect(picker.vertex(1, 1, 0.5)).toBe(0);
  expect(picker.vertex(5, 1, 0.5)).toBe(99_999);
});
