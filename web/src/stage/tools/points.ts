// Points: a click adds one, and a click with Shift removes one; what is dragged moves.

import { drawing, edit, inTurn } from "../../state/drawing";
import type { Place, Tool } from "../tool";
import { dragTo, grab, release } from "./drag";
import { addPoint, remove } from "./edits";
import { pointNear, segmentNear } from "./under";

export const points: Tool = {
  cursor: "crosshair",
  down(place: Place): boolean {
    const point = pointNear(place);
    if (point === null || place.event.shiftKey) return false;
    grab({ kind: "point", point });
    return true;
  },
  click(place: Place): void {
    const [point, isRemoving] = [pointNear(place), place.event.shiftKey];
    if (point !== null && isRemoving) void edit(remove({ kind: "point", point }));
    else if (point === null && !isRemoving) void add(place);
  },
  move: ({ x, y }) => dragTo(x, y),
  up: () => void release(),
  cancel: () => void release(),
};

/** Adds a point where there is none; which segments are there is asked when all edits before have been made. */
async function add(place: Place): Promise<void> {
  await inTurn(async () => {});
  const drawn = drawing.peek();
  if (drawn) await edit(...addPoint(drawn, place.x, place.y, segmentNear(place)));
}
