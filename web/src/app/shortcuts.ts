// Keys that work everywhere on the page, except where text is written.

import { useEffect } from "preact/hooks";
import { cancelJobs } from "../state/job";

/** What each key does, by `event.key`. Rooms add theirs. */
export const shortcuts = new Map<string, () => void>([["Escape", cancelJobs]]);

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
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (target instanceof HTMLElement && target.matches("input:not([type=range]), textarea, select")) return;
  // Buttons are pressed by the space bar.
  if (key === " " && target instanceof HTMLElement && target.matches("button, summary, a")) return;
  const action = shortcuts.get(key);
  if (!action) return;
  event.preventDefault();
  action();
}
