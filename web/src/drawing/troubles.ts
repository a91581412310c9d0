// Marks of what is wrong: places, segments and points that an error names, until its notice is dismissed.

import { effect } from "@preact/signals";
import type { DrawingData, Marks } from "../engine/protocol";
import { widened } from "../stage/attention";
import { type Box, boxOf } from "../stage/camera";
import type { Pen } from "../stage/pen";
import { drawing } from "../state/drawing";
import { dismissMarks, notices } from "../state/notices";

// What is wrong with a drawing is not wrong with the next one.
let last: DrawingData | null = null;
effect(() => {
  if (last && drawing.value !== last) dismissMarks();
  last = drawing.value;
});

/** Returns all coordinates that are marked in a drawing. */
export function markedPlaces(marks: Marks, { points, segments }: DrawingData): number[] {
  const ends = [...marks.segments].flatMap((k) => [...segments.subarray(2 * k, 2 * k + 2)]);
  const numbers = [...ends, ...marks.points];
  return [...marks.places, ...numbers.flatMap((i) => [...points.subarray(2 * i, 2 * i + 2)])];
}

/** Returns the box around places, or else around all that is marked, with some room; null if that is nowhere. */
export function boxOfMarks(marks: Marks | undefined): Box | null {
  const drawn = drawing.value;
  if (!marks || !drawn) return null;
  const exact = [...marks.places];
  const places = Float64Array.from(exact.length > 0 ? exact : markedPlaces(marks, drawn));
  if (places.length === 0) return null;
  const [box, all] = [boxOf(places), boxOf(drawn.points)];
  const size = ({ low, high }: Box) => Math.max(high[0] - low[0], high[1] - low[1]);
  return widened(box, Math.max(size(box) / 2, size(all) / 20));
}

/** Draws the marks of all notices. */
export function drawTroubles(pen: Pen): void {
  const drawn = drawing.value;
  if (!drawn) return;
  const colour = pen.palette.bad;
  for (const { marks } of notices.value) {
    if (!marks) continue;
    for (const k of marks.segments) {
      const ends = drawn.segments.subarray(2 * k, 2 * k + 2);
      if (ends.length === 2) pen.polygon(drawn.points, ends, { stroke: colour, width: 3.5 });
    }
    const places = marks.places.length > 0 ? marks.places : markedPlaces(marks, drawn);
    for (let i = 0; i + 1 < places.length; i += 2) {
      pen.dot(places[i], places[i + 1], { stroke: pen.palette.paper, width: 5, size: 9 });
      pen.dot(places[i], places[i + 1], { stroke: colour, width: 2.5, size: 9 });
    }
  }
}
