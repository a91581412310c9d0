// Where the sweep is.

import { pale } from "../stage/palette";
import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";

/** Draws the line or the circle of the sweep, with a soft edge. */
export const sweep: Overlay = (pen) => {
  const where = frame.value?.sweep;
  if (!where) return;
  const colour = pen.palette.sweep;
  const looks = [
    { stroke: pale(colour, 0.14), width: 11 },
    { stroke: colour, width: 2 },
  ];
  for (const look of looks) {
    if ("circle" in where) pen.circle(...where.circle.center, where.circle.radius, look);
    else pen.across(where, look);
  }
};
