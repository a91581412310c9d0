// Which edits a gesture means. Nothing here changes anything.

import type { DrawingData, Edit } from "../../engine/protocol";
import { hasSegment } from "./near";
import type { Under } from "./under";

/** Adds a point; on a segment, which is near there, it cuts that in two. */
export function addPoint(drawn: DrawingData, x: number, y: number, segment: number | null): Edit[] {
  if (segment === null) return [{ addPoint: [x, y] }];
  const point = drawn.points.length / 2;
  const [from, to] = drawn.segments.subarray(2 * segment, 2 * segment + 2);
  return [
    { removeSegment: segment },
    { addPoint: [x, y] },
    { addSegment: [from, point] },
    { addSegment: [point, to] },
  ];
}

/** Joins two points, unless they are already joined or one. */
export function join({ segments }: DrawingData, from: number, to: number): Edit[] {
  return from === to || hasSegment(segments, from, to) ? [] : [{ addSegment: [from, to] }];
}

/** Removes what is under a pointer. */
export function remove(what: Under): Edit {
  switch (what.kind) {
    case "point":
      return { removePoint: what.point };
    case "hole":
      return { removeHole: what.hole };
    case "segment":
      return { removeSegment: what.segment };
  }
}
