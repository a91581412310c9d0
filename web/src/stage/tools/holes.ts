// Holes: a click marks the hole around it, a click with Shift takes the mark away; a mark that is dragged moves.

import { editBy } from "../../state/drawing";
import type { Place, Tool } from "../tool";
import { dragTo, grab, release } from "./drag";
import { holeNear } from "./under";

export const holes: Tool = {
  cursor: "crosshair",
  down(place: Place): boolean {
    const hole = holeNear(place);
    if (hole === null || place.event.shiftKey) return false;
    grab({ kind: "hole", hole });
    return true;
  },
  click(place: Place): void {
    void editBy(() => {
      const hole = holeNear(place);
      return [hole === null ? { addHole: [place.x, place.y] } : { removeHole: hole }];
    });
  },
  move: ({ x, y }) => dragTo(x, y),
  up: () => void release(),
  cancel: () => void release(),
};
