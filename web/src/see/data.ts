// Data and what they count for: which triangle holds a datum, and where clusters have their centers.

import { stage } from "../engine/client";
import { pale } from "../stage/palette";
import { middleOf, placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { frame, SLOT } from "../state/play";
import { asked } from "./asking";
import { byHolder } from "./holding";
import { chip, Labels } from "./looks";
import { looksAt, standing } from "./turn";

const held = asked(
  stage,
  () => (looksAt("holders") ? standing.value : null),
  (engine, { position }) => engine.looks.holders(SLOT, position),
);

/** Draws a line from each datum to the middle of its triangle, and there how many it holds. */
export const holders: Overlay = (pen) => {
  const points = frame.value?.points;
  if (!points || !held.value) return;
  const all = byHolder(held.value);
  const colour = pen.palette.locked;
  for (const { triangle, data } of all) {
    const middle = middleOf(points, triangle);
    for (const v of data) pen.path([placeOf(points, v), middle], { stroke: pale(colour, 0.45), width: 1 });
  }
  const labels = new Labels();
  for (const { triangle, data } of all) {
    labels.chip(pen, ...pen.at(...middleOf(points, triangle)), String(data.length), colour);
  }
};

/** Draws the centers of clusters, with their numbers. */
export const clusters: Overlay = (pen) => {
  const rows = frame.value?.clusters ?? new Float64Array();
  for (let i = 0; i < rows.length; i += 3) {
    const [number, x, y] = rows.subarray(i, i + 3);
    pen.dot(x, y, { stroke: pale(pen.palette.front, 0.35), width: 8, size: 11 });
    pen.dot(x, y, { stroke: pen.palette.front, width: 2, size: 11, fill: pen.palette.paper });
    const [px, py] = pen.at(x, y);
    chip(pen, px, py, String(number), pen.palette.front);
  }
};
