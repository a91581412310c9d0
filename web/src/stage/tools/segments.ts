// Segments: from point to point, click by click. A click where no point is adds one; one on the first point closes the
// ring; the last point once more, or Escape, ends.

import { signal } from "@preact/signals";
import { drawing, edit, inTurn } from "../../state/drawing";
import type { Place, Tool } from "../tool";
import { addPoint, join } from "./edits";
import { pointNear, segmentNear } from "./under";

/** The points of the line that is being drawn, by number: its first and its last; null: none is. */
export const line = signal<{ first: number; last: number } | null>(null);

/** Ends the line that is being drawn; returns whether there was one. */
export function endLine(): boolean {
  const was = line.peek() !== null;
  line.value = null;
  return was;
}

export const segments: Tool = {
  cursor: "crosshair",
  down: () => false,
  click: (place: Place) => void go(place),
  cancel: () => void endLine(),
};

// Each click begins where the one before has ended.
let steps: Promise<unknown> = Promise.resolve();

function go(place: Place): Promise<unknown> {
  steps = steps.then(() => step(place)).catch(() => {});
  return steps;
}

async function step(place: Place): Promise<void> {
  await inTurn(async () => {});
  const drawn = drawing.peek();
  if (!drawn) return;
  const near = pointNear(place);
  const before = line.peek();
  const count = drawn.points.length / 2;
  const isThere = (point: number) => point < count;
  const from = before && isThere(before.first) && isThere(before.last) ? before : null;
  const added = near === null ? addPoint(drawn, place.x, place.y, segmentNear(place)) : [];
  const point = near ?? count;
  const joined = from ? join(drawn, from.last, point) : [];
  const edits = [...added, ...joined];
  if (edits.length > 0 && !(await edit(...edits))) return;
  const isEnd = from !== null && (point === from.first || point === from.last);
  line.value = isEnd ? null : { first: from?.first ?? point, last: point };
}
