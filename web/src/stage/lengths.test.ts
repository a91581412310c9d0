// Edges by their lengths.

import { expect, test } from "vitest";
import { anchorOf } from "./anchor";
import { boxOf } from "./camera";
import { longerThan, sortEdges } from "./lengths";

test("long edges come first, constraints apart", () => {
  const points = Float64Array.of(0, 0, 1000, 0, 1000, 1, 0, 1e-3, 700, 0);
  const edges = Uint32Array.of(1, 2, 0, 3, 0, 1, 3, 4, 4, 4);
  const scene = {
    points,
    edges,
    locked: Uint8Array.of(0, 0, 0, 1, 0),
    triangles: new Uint32Array(),
    values: null,
    hasDots: true,
  };
  const anchor = anchorOf(boxOf(points));
  const { ordinary, locked } = sortEdges(scene, anchor);
  expect([...ordinary.edges]).toEqual([0, 1, 1, 2, 0, 3, 4, 4]);
  expect([...locked.edges]).toEqual([3, 4]);
  const drawn = (length: number) => longerThan(ordinary, length / anchor.unit);
  expect([5000, 500, 0.4, 4e-4, 0].map(drawn)).toEqual([0, 1, 2, 3, 4]);
  expect(longerThan(locked, 0)).toBe(1);
});
