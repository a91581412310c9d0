// The game on the stage: what is offered, what is hinted, and what was right.

import type { Pen } from "../stage/pen";
import type { Overlay } from "../stage/Stage";
import { type Answered, answered, difficulty, isHinted, type Puzzle, puzzle } from "../state/predict";
import { keyOf, type Quad } from "./edges";
import { hovered } from "./tool";

/** Draws the puzzle, or its solution. */
export const game: Overlay = (pen) => {
  if (!puzzle.value) return;
  if (answered.value) drawSolution(pen, puzzle.value, answered.value);
  else drawPuzzle(pen, puzzle.value);
};

function drawPuzzle(pen: Pen, { points, all, offered, illegal }: Puzzle): void {
  const { palette } = pen;
  if (isHinted.value)
    for (const { edge } of all)
      if (illegal.has(keyOf(edge)))
        pen.polygon(points, edge, { stroke: palette.bad, width: 3, dash: [2, 6] });
  const shown = difficulty.value === "three" ? offered : [];
  for (const { edge } of shown) pen.polygon(points, edge, { stroke: palette.asked, width: 5 });
  if (hovered.value) pen.polygon(points, hovered.value.edge, { stroke: palette.front, width: 7 });
  for (const [i, quad] of shown.entries()) drawNumber(pen, points, quad, i + 1);
}

function drawSolution(pen: Pen, { points, answer }: Puzzle, { guess, verdict, because }: Answered): void {
  const { palette } = pen;
  const circle = because?.circle;
  if (circle) pen.circle(...circle.center, circle.radius, { stroke: palette.good, width: 1.5, dash: [6, 4] });
  if (verdict !== "right") {
    const stroke = verdict === "almost" ? palette.asked : palette.bad;
    pen.polygon(points, guess.edge, { stroke, width: 5 });
  }
  pen.polygon(points, answer.edge, { stroke: palette.good, width: 6 });
  pen.polygon(points, answer.apexes, { stroke: palette.good, width: 2.5, dash: [3, 6] });
  for (const v of answer.apexes) pen.dot(points[2 * v], points[2 * v + 1], { fill: palette.good, size: 5 });
}

/** Writes a number in a disk, in the middle of an edge. */
function drawNumber(pen: Pen, points: Float64Array, { edge: [a, b] }: Quad, number: number): void {
  const { palette, context } = pen;
  const x = points[2 * a] / 2 + points[2 * b] / 2;
  const y = points[2 * a + 1] / 2 + points[2 * b + 1] / 2;
  pen.dot(x, y, { fill: palette.paper, stroke: palette.asked, width: 2, size: 11 });
  context.save();
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = palette.ink;
  context.fillText(String(number), ...pen.at(x, y));
  context.restore();
}
