// What a racer does just now: thin marks, for races are fast.

import { pale } from "../stage/palette";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import type { Lane } from "../state/race";

/** Makes the overlay of a lane. */
export const laneMarks =
  ({ frame, run }: Lane): Overlay =>
  (pen) => {
    const shown = frame.value;
    if (!shown?.step || shown.position === run.length) return;
    const { points, front } = shown;
    if (front.length > 1) {
      const places = Array.from(front, (v) => placeOf(points, v));
      pen.path(places, { stroke: pen.palette.front, width: 2 });
    }
    for (const mark of shown.step.marks) {
      const colour = pen.palette[mark.tone];
      if (mark.shape === "triangle") pen.polygon(points, mark.triangle, { fill: pale(colour, 0.25) });
      if (mark.shape === "edge") pen.polygon(points, mark.edge, { stroke: colour, width: 3 });
      if (mark.shape === "vertex") pen.dot(...placeOf(points, mark.vertex), { fill: colour, size: 4.5 });
    }
  };
