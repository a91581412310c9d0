// The drawing over whatever the stage shows: its segments and holes, what a tool has in hand, and what is wrong.

import type { DrawingData } from "../engine/protocol";
import type { Pen } from "../stage/pen";
import type { Overlay } from "../stage/Stage";
import { pointer } from "../stage/tool";
import { inHand } from "../stage/tools/box";
import { dragged } from "../stage/tools/drag";
import { line } from "../stage/tools/segments";
import { hovered, pointNear, segmentNear } from "../stage/tools/under";
import { drawing } from "../state/drawing";
import { mode } from "../state/mode";
import { frame } from "../state/play";
import { drawTroubles } from "./troubles";

/** More segments than this are not drawn over a scene that leaves them aside. */
const MOST_SEGMENTS = 20_000;

export const drawn: Overlay = (pen) => {
  if (!drawing.value) return;
  leftAside(pen, drawing.value);
  const { holes } = drawing.value;
  for (let i = 0; i < holes.length; i += 2) cross(pen, holes[i], holes[i + 1], pen.palette.locked);
  if (inHand.value !== "view") inProgress(pen, drawing.value);
  drawTroubles(pen);
};

/** Draws segments that the scene of a run does not have, or not yet; over those it has these are not seen. */
function leftAside(pen: Pen, { points, segments }: DrawingData): void {
  if (mode.value === "mesh" || !frame.value || segments.length > 2 * MOST_SEGMENTS) return;
  const { context, palette } = pen;
  context.beginPath();
  for (let k = 0; k < segments.length; k += 2) {
    const [a, b] = [2 * segments[k], 2 * segments[k + 1]];
    context.moveTo(...pen.at(points[a], points[a + 1]));
    context.lineTo(...pen.at(points[b], points[b + 1]));
  }
  Object.assign(context, { strokeStyle: palette.locked, lineWidth: 1.5 });
  context.setLineDash([5, 4]);
  context.stroke();
}

function inProgress(pen: Pen, data: DrawingData): void {
  const held = dragged.value;
  if (held) {
    if (held.what.kind === "point") star(pen, data, held.what.point, held.x, held.y);
    else cross(pen, held.x, held.y, pen.palette.asked);
  } else {
    hint(pen, data);
    if (inHand.value === "segments") nextSegment(pen, data);
  }
}

/** Draws a point that is moved, with its segments. */
function star(pen: Pen, { points, segments }: DrawingData, point: number, x: number, y: number): void {
  for (let k = 0; k < segments.length; k++) {
    if (segments[k] !== point) continue;
    const other = 2 * segments[k ^ 1];
    const ends: [number, number][] = [
      [x, y],
      [points[other], points[other + 1]],
    ];
    pen.path(ends, { stroke: pen.palette.asked, width: 2, dash: [5, 4] });
  }
  pen.dot(x, y, { fill: pen.palette.asked, size: 5 });
}

/** Draws a ring around what a click would meet. */
function hint(pen: Pen, { points, segments, holes }: DrawingData): void {
  const what = hovered.value;
  if (!what) return;
  const [name, colour] = [inHand.value, inHand.value === "erase" ? pen.palette.bad : pen.palette.asked];
  if (what.kind === "segment") {
    if (name === "holes") return;
    pen.polygon(points, segments.subarray(2 * what.segment, 2 * what.segment + 2), {
      stroke: colour,
      width: 4,
    });
  } else if (what.kind === "point") {
    if (name === "holes") return;
    pen.dot(points[2 * what.point], points[2 * what.point + 1], { stroke: colour, width: 2, size: 7 });
  } else if (name === "holes" || name === "erase") {
    pen.dot(holes[2 * what.hole], holes[2 * what.hole + 1], { stroke: colour, width: 2, size: 10 });
  }
}

/** Draws the segment that the next click makes. */
function nextSegment(pen: Pen, { points }: DrawingData): void {
  const [from, to] = [line.value, pointer.value];
  if (!from || !to) return;
  const near = pointNear(to);
  const end: [number, number] = near === null ? [to.x, to.y] : [points[2 * near], points[2 * near + 1]];
  const begin: [number, number] = [points[2 * from.last], points[2 * from.last + 1]];
  pen.path([begin, end], { stroke: pen.palette.asked, width: 2, dash: [6, 4] });
  pen.dot(points[2 * from.first], points[2 * from.first + 1], {
    stroke: pen.palette.asked,
    width: 2,
    size: 6,
  });
  if (near === null && segmentNear(to) === null) pen.dot(...end, { fill: pen.palette.asked, size: 3.5 });
}

/** Draws the mark of a hole. */
function cross(pen: Pen, x: number, y: number, colour: string): void {
  const [px, py] = pen.at(x, y);
  const { context } = pen;
  context.setLineDash([]);
  for (const [stroke, width] of [
    [pen.palette.paper, 4],
    [colour, 2],
  ] as const) {
    Object.assign(context, { strokeStyle: stroke, lineWidth: width });
    context.beginPath();
    context.moveTo(px - 4, py - 4);
    context.lineTo(px + 4, py + 4);
    context.moveTo(px + 4, py - 4);
    context.lineTo(px - 4, py + 4);
    context.stroke();
  }
}
