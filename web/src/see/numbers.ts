// The numbers of the vertices.

import type { Overlay } from "../stage/Stage";
import { isNear, strength } from "./looks";
import { shown } from "./shown";

/** Room in pixels for a number, to be drawn in full. */
const ROOM = 44;

/** Draws the numbers; they fade when there are too many. */
export const numbers: Overlay = (pen) => {
  const points = shown.value?.points;
  if (!points) return;
  const seen: number[] = [];
  for (let v = 0; 2 * v < points.length; v++) if (isNear(pen, points[2 * v], points[2 * v + 1])) seen.push(v);
  const share = strength(pen, seen.length, ROOM);
  if (share === 0) return;
  pen.context.globalAlpha = share;
  for (const v of seen) pen.label(points[2 * v], points[2 * v + 1], String(v), pen.palette.ink);
  pen.context.globalAlpha = 1;
};
