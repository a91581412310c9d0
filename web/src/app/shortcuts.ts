// Keys that work everywhere on the page, except where text is written.

import { useEffect } from "preact/hooks";
import { cancelJobs } from "../state/job";
import { type Mode, mode, modes } from "../state/mode";

/** What each key does: `event.key`, letters small, with `Shift+` before it. Rooms add theirs. */
export const shortcuts = new Map<string, () => void>([["Escape", cancelJobs]]);

/** What keys do in one mode alone; these come before the others. */
export const modeShortcuts = Object.fromEntries(modes.map((each) => [each, new Map()])) as Record<
  Mode,
  Map<string, () => void>
>;

export function useShortcuts(): void {
  useEffect(() => {
    document.addEventListener("keydown", press);
    return () => document.removeEventListener("keydown", press);
  }, []);
}

function press(event: KeyboardEvent): void {
  const { target, key } = event;
  // A dialog has keys of its own.
  if (document.querySelector("dialog[open]")) return;
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
  if (target instanceof HTMLElement && target.matches("input:not([type=range]), textarea, select")) return;
  // Buttons are pressed by these two.
  if (
    (key === " " || key === "Enter") &&
    target instanceof HTMLElement &&
    target.matches("button, summary, a")
  )
    return;
  const name = (event.shiftKey ? "Shift+" : "") + (key.length === 1 ? key.toLowerCase() : key);
  const action = modeShortcuts[mode.peek()].get(name) ?? shortcuts.get(name) ?? shortcuts.get(key);
  if (!action) return;
  event.preventDefault();
  action();
}
