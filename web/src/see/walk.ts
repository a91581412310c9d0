// The walk, or the search, by which a point is being found, or a segment followed.

import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";
import { middleOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";
import { fillHead, headOf, type Pixel } from "./arrows";
import { Labels } from "./looks";
import { isPath, type Stop, stopsOf, walkOf } from "./stops";
import { turn } from "./turn";

/** Draws what has been visited, and the way. */
export const walk: Overlay = (pen) => {
  const points = frame.value?.points;
  const stops = stopsOf(walkOf(turn.value));
  if (!points || stops.length === 0) return;
  const colour = pen.palette.sweep;
  for (const { vertices } of stops) {
    if (vertices.length === 3) pen.polygon(points, vertices, { fill: pale(colour, 0.16) });
    else pen.polygon(points, vertices, { stroke: pale(colour, 0.55), width: 3 });
  }
  const pixels = stops.map(({ vertices }) => pen.at(...middleOf(points, vertices)));
  if (isPath(stops)) drawWay(pen, stops, pixels, colour);
  const labels = new Labels();
  for (const [i, pixel] of pixels.entries()) {
    // Where it stands now there is an arrow, or the mark of the step.
    if (i < stops.length - 1) labels.chip(pen, ...pixel, String(i + 1), colour);
  }
};

function drawWay(pen: Pen, stops: Stop[], pixels: Pixel[], colour: string): void {
  const { context } = pen;
  context.beginPath();
  for (const [i, { isLinked }] of stops.entries()) {
    if (isLinked) context.lineTo(...pixels[i]);
    else context.moveTo(...pixels[i]);
  }
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.setLineDash([]);
  context.stroke();
  const last = stops.length - 1;
  if (stops[last].isLinked) fillHead(context, headOf(pixels[last - 1], pixels[last], 11), colour);
}
