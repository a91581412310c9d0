// Keys for those who draw: one for each tool, and those that take changes back.

import { shortcuts } from "../app/shortcuts";
import { removeHovered, stop, take, toolKeys, toolNames } from "../stage/tools/box";
import { endLine } from "../stage/tools/segments";
import { redo, undo } from "../state/drawing";
import { cancelJobs, jobs } from "../state/job";

/** Makes the keys work until the returned function is called. */
export function listenForKeys(): () => void {
  for (const name of toolNames) shortcuts.set(toolKeys[name], () => take(name));
  shortcuts.set("Delete", removeHovered);
  shortcuts.set("Backspace", removeHovered);
  shortcuts.set("Escape", giveUp);
  document.addEventListener("keydown", withControl);
  return () => document.removeEventListener("keydown", withControl);
}

/** Ends work first, then the line that is drawn, then lays the tool down. */
function giveUp(): void {
  if (jobs.peek().length > 0) cancelJobs();
  else stop();
}

function withControl(event: KeyboardEvent): void {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const { target } = event;
  // Fields take their own text back.
  if (target instanceof HTMLElement && target.matches("input:not([type=range]), textarea, dialog *")) return;
  const key = event.key.toLowerCase();
  const action = key === "y" || (key === "z" && event.shiftKey) ? redo : key === "z" ? undo : null;
  if (!action) return;
  event.preventDefault();
  endLine();
  void action();
}
