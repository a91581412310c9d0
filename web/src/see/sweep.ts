// Where the sweep is.

import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";
import { drawCircle } from "./circles";
import { pale } from "./looks";

/** Draws the line or the circle of the sweep, with a soft edge. */
export const sweep: Overlay = (pen) => {
  const where = frame.value?.sweep;
  if (!where) return;
  const colour = pen.palette.sweep;
  const looks = [
    { stroke: pale(colour, 0.14), width: 11 },
    { stroke: colour, width: 2 },
  ];
  const { low, high } = pen.seen;
  for (const look of looks) {
    if ("circle" in where) {
      const [x, y] = where.circle.center;
      drawCircle(pen, { x, y, radius: where.circle.radius }, look);
    } else if ("vertical" in where) {
      pen.path(
        [
          [where.vertical, low[1]],
          [where.vertical, high[1]],
        ],
        look,
      );
    } else {
      pen.path(
        [
          [low[0], where.horizontal],
          [high[0], where.horizontal],
        ],
        look,
      );
    }
  }
};
