// The front of a sweep: the polyline through its vertices with the direction in which it runs, or the beach line.

import type { Frame } from "../engine/protocol";
import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { hasSegment } from "../stage/tools/near";
import { frame, run } from "../state/play";
import { fillHead, headOf } from "./arrows";
import { arcsOf, heightAt } from "./beach";
import { isNear } from "./looks";

/** The algorithm whose front is a beach line: there the vertices of the front are sites of arcs. */
const BEACH = "fortune";

/** Draws the front. */
export const front: Overlay = (pen) => {
  const shown = frame.value;
  if (!shown || shown.front.length === 0) return;
  if (run.value?.algorithm === BEACH) beach(pen, shown);
  else line(pen, shown);
};

function line(pen: Pen, { points, front: vertices, edges }: Frame): void {
  const colour = pen.palette.front;
  const places = Array.from(vertices, (v) => placeOf(points, v));
  if (isClosed(vertices, edges)) places.push(places[0]);
  pen.path(places, { stroke: pale(colour, 0.2), width: 9 });
  pen.path(places, { stroke: colour, width: 3 });
  for (let i = 1; i < places.length; i++) {
    const [from, to] = [pen.at(...places[i - 1]), pen.at(...places[i])];
    const middle: [number, number] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    const isLong = Math.hypot(to[0] - from[0], to[1] - from[1]) > 28;
    if (isLong && isNear(pen, ...placeOf(points, vertices[i - 1]), 500)) {
      fillHead(pen.context, headOf(from, middle, 9), colour);
    }
  }
}

/** Tells whether the front comes back to where it begins: fronts of circles do. */
function isClosed(vertices: Uint32Array, edges: Uint32Array): boolean {
  return vertices.length > 2 && hasSegment(edges, vertices[0], vertices[vertices.length - 1]);
}

function beach(pen: Pen, { points, front: sites, sweep }: Frame): void {
  if (!sweep || !("horizontal" in sweep)) return;
  const { low, high } = pen.seen;
  const height = sweep.horizontal;
  const colour = pen.palette.front;
  for (const { site, left, right } of arcsOf(points, sites, height, low[0], high[0])) {
    const [px, py] = placeOf(points, site);
    if (py <= height)
      pen.path(
        [
          [px, py],
          [px, high[1]],
        ],
        { stroke: colour, width: 2.5, dash: [5, 4] },
      );
    const [from, to] = [Math.max(left, low[0]), Math.min(right, high[0])];
    if (py <= height || from >= to) continue;
    // A point for every other pixel.
    const pieces = Math.max(2, Math.min(400, Math.ceil(((to - from) * pen.camera.scale) / 2)));
    const arc = Array.from({ length: pieces + 1 }, (_, i): [number, number] => {
      const x = from + ((to - from) * i) / pieces;
      return [x, Math.min(heightAt(x, px, py, height), high[1] + 1 / pen.camera.scale)];
    });
    pen.path(arc, { stroke: pale(colour, 0.2), width: 8 });
    pen.path(arc, { stroke: colour, width: 2.5 });
  }
}
