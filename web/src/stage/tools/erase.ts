// The eraser: what is clicked goes; a point with the segments that end there.

import { editBy } from "../../state/drawing";
import type { Place, Tool } from "../tool";
import { remove } from "./edits";
import { under } from "./under";

export const erase: Tool = {
  cursor: "crosshair",
  down: () => false,
  click(place: Place): void {
    void editBy(() => {
      const what = under(place);
      return what ? [remove(what)] : [];
    });
  },
};
