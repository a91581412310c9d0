// What the step that has just been taken is about.

import type { Mark } from "../engine/protocol";
import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";
import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";

/** Draws the marks of the step: triangles below circles below edges below points. */
export const marks: Overlay = (pen) => {
  const shown = frame.value;
  if (!shown?.step) return;
  const order = ["triangle", "cut", "circle", "edge", "vertex", "place"];
  const sorted = shown.step.marks.toSorted((a, b) => order.indexOf(a.shape) - order.indexOf(b.shape));
  for (const mark of sorted) draw(pen, mark, shown.points);
};

function draw(pen: Pen, mark: Mark, points: Float64Array): void {
  const colour = pen.palette[mark.tone];
  switch (mark.shape) {
    case "triangle":
      pen.polygon(points, mark.triangle, { fill: pale(colour, 0.25) });
      break;
    case "circle":
      pen.circle(...mark.center, mark.radius, { stroke: colour, width: 1.5, dash: [6, 4] });
      break;
    case "edge":
      pen.polygon(points, mark.edge, { stroke: colour, width: 4 });
      break;
    case "vertex":
      pen.dot(points[2 * mark.vertex], points[2 * mark.vertex + 1], { fill: colour, size: 6 });
      break;
    case "place":
      pen.dot(...mark.at, { stroke: colour, width: 2.5, size: 6 });
      break;
    case "cut":
      pen.across(mark.cut, { stroke: colour, width: 2, dash: [8, 5] });
      break;
  }
}
