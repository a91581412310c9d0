import { expect, test } from "vitest";
import type { DrawingData } from "../../engine/protocol";
import { addPoint, join, remove } from "./edits";

const drawn: DrawingData = {
  points: Float64Array.of(0, 0, 4, 0, 4, 3),
  segments: Uint32Array.of(0, 1),
  holes: new Float64Array(),
  regions: new Float64Array(),
  about: {
    points: 3,
    segments: 1,
    holes: 0,
    regions: 0,
    triangles: 0,
    rule: "carve",
    attributes: [],
    leftOut: [],
  },
};

test("a point on a segment cuts it in two", () => {
  expect(addPoint(drawn, 9, 9, null)).toEqual([{ addPoint: [9, 9] }]);
  expect(addPoint(drawn, 2, 0, 0)).toEqual([
    { removeSegment: 0 },
    { addPoint: [2, 0] },
    { addSegment: [0, 3] },
    { addSegment: [3, 1] },
  ]);
});

test("what is joined is not joined again", () => {
  expect(join(drawn, 1, 2)).toEqual([{ addSegment: [1, 2] }]);
  expect(join(drawn, 1, 0)).toEqual([]);
  expect(join(drawn, 2, 2)).toEqual([]);
});

test("each kind is removed by its number", () => {
  expect(remove({ kind: "point", point: 2 })).toEqual({ removePoint: 2 });
  expect(remove({ kind: "hole", hole: 1 })).toEqual({ removeHole: 1 });
  expect(remove({ kind: "segment", segment: 0 })).toEqual({ removeSegment: 0 });
});
