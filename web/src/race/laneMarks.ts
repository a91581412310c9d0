// What a racer does just now: thin marks, for races are fast.

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
      const places = Array.from(front, (v): [number, number] => [points[2 * v], points[2 * v + 1]]);
      pen.path(places, { stroke: pen.palette.front, width: 2 });
    }
    for (const mark of shown.step.marks) {
      const colour = pen.palette[mark.tone];
      if (mark.shape === "triangle") pen.polygon(points, mark.triangle, { fill: `${colour}40` });
      if (mark.shape === "edge") pen.polygon(points, mark.edge, { stroke: colour, width: 3 });
      if (mark.shape === "vertex") {
        const [x, y] = [points[2 * mark.vertex], points[2 * mark.vertex + 1]];
        pen.dot(x, y, { fill: colour, size: 4.5 });
      }
    }
  };
