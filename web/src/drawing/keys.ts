// Keys for those who draw: one for each tool, and those that take changes back.

import { bind } from "../app/shortcuts";
import { removeHovered, stop, take, toolKeys, toolNames } from "../stage/tools/box";
import { endLine } from "../stage/tools/segments";
import { redo, undo } from "../state/drawing";
import { cancelJobs, jobs } from "../state/job";

for (const name of toolNames) bind("drawing", toolKeys[name], name, () => take(name));
bind("drawing", "Delete", "remove", removeHovered);
bind("drawing", "Backspace", "remove", removeHovered);
bind("drawing", "Control+z", "undo", changing(undo));
bind("drawing", "Control+Shift+z", "redo", changing(redo));
bind("drawing", "Control+y", "redo", changing(redo));
bind("page", "Escape", "escape", giveUp);

/** Ends work first, then the line that is drawn, then lays the tool down. */
function giveUp(): void {
  if (jobs.peek().length > 0) cancelJobs();
  else stop();
}

/** A line that is being drawn ends before something is taken back. */
function changing(act: () => unknown): () => void {
  return () => {
    endLine();
    void act();
  };
}
