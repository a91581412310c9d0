// Points: a click adds one, and a click with Shift removes one; what is dragged moves.

import { editBy } from "../../state/drawing";
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
    const isRemoving = place.event.shiftKey;
    void editBy((drawn) => {
      const point = pointNear(place);
      if (isRemoving) return point === null ? [] : [remove({ kind: "point", point })];
      return point === null ? addPoint(drawn, place.x, place.y, segmentNear(place)) : [];
    });
  },
  move: ({ x, y }) => dragTo(x, y),
  up: () => void release(),
  cancel: () => void release(),
};
