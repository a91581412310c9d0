// What the step that has just been taken is about. Tones differ by shape as well as by colour, for those who see no
// difference between red and green: what goes is broken or a cross, what is looked at a ring.

import type { Mark, Tone } from "../engine/protocol";
import { pale } from "../stage/palette";
import type { Look, Pen } from "../stage/pen";
import { placeOf } from "../stage/places";
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
      pen.polygon(points, mark.triangle, {
        fill: pale(colour, 0.25),
        ...(mark.tone === "bad" && goes(colour, 2)),
      });
      break;
    case "circle":
      pen.circle(...mark.center, mark.radius, { stroke: colour, width: 1.5, dash: [6, 4] });
      break;
    case "edge":
      pen.polygon(points, mark.edge, mark.tone === "bad" ? goes(colour, 4) : { stroke: colour, width: 4 });
      break;
    case "vertex":
      vertex(pen, placeOf(points, mark.vertex), mark.tone);
      break;
    case "place":
      if (mark.tone === "bad") pen.cross(...mark.at, { stroke: colour, width: 2.5, size: 5 });
      else pen.dot(...mark.at, { stroke: colour, width: 2.5, size: 6 });
      break;
    case "cut":
      pen.across(mark.cut, { stroke: colour, width: 2, dash: [8, 5] });
      break;
  }
}

/** How lines look of what goes. */
const goes = (colour: string, width: number): Look => ({
  stroke: colour,
  width,
  dash: [2 * width, 2 * width],
});

function vertex(pen: Pen, [x, y]: [number, number], tone: Tone): void {
  const colour = pen.palette[tone];
  const { paper } = pen.palette;
  if (tone === "good") pen.dot(x, y, { fill: colour, size: 6 });
  if (tone === "asked") pen.dot(x, y, { fill: paper, stroke: colour, width: 3.5, size: 5.5 });
  if (tone !== "bad") return;
  pen.cross(x, y, { stroke: paper, width: 7, size: 6 });
  pen.cross(x, y, { stroke: colour, width: 3.5, size: 6 });
}
