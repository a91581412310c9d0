// The last test of a circle: the circle, the fourth point, the exact answer, and who decides where there is a tie.

import { pale } from "../stage/palette";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";
import { words } from "../words";
import { circumcircle } from "./circles";
import { largest, lastTest } from "./circleTests";
import { chip } from "./looks";
import { turn } from "./turn";

/** Draws the test. */
export const circle: Overlay = (pen) => {
  const shown = frame.value;
  const test = shown && lastTest(turn.value);
  if (!test) return;
  const { points } = shown;
  const colour = test.is_inside ? pen.palette.bad : pen.palette.good;
  const round = circumcircle(points, test.triangle);
  if (round)
    pen.circle(round.x, round.y, round.radius, { stroke: colour, width: 2, fill: pale(colour, 0.07) });
  pen.polygon(points, test.triangle, { stroke: pale(colour, 0.6), width: 2 });
  pen.dot(...placeOf(points, test.point), { fill: colour, stroke: pen.palette.paper, width: 2, size: 7 });
  const { sides, onCircle, raised } = words.value.see;
  // Chips stand away from the middle of the circle, where the least is drawn.
  const middle = round ? pen.at(round.x, round.y) : [0, 0];
  const write = (v: number, away: number, text: string, ink: string, strong: boolean) => {
    const [x, y] = pen.at(...placeOf(points, v));
    const [dx, dy] = [x - middle[0], y - middle[1]];
    const length = Math.hypot(dx, dy) || 1;
    chip(pen, x + (dx / length) * away * 1.6, y + (dy / length) * away, text, ink, strong);
  };
  const isTie = test.answer === "on";
  const counts = sides[test.is_inside ? "inside" : "outside"];
  write(test.point, 26, isTie ? onCircle(counts) : counts, colour, true);
  if (!isTie) return;
  const judge = largest(points, [...test.triangle, test.point]);
  pen.dot(...placeOf(points, judge), { stroke: pen.palette.asked, width: 2.5, size: 11 });
  write(judge, judge === test.point ? 58 : 26, raised, pen.palette.asked, false);
};
