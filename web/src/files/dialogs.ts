// Which dialog is open.

import { signal } from "@preact/signals";
import type { What } from "./choices";

export const dialog = signal<"save" | "paste" | "help" | null>(null);

/** What the dialog of saving begins with; null: what suits the mode. */
export const wanted = signal<What | null>(null);

/** Opens the dialog of saving, with something to begin with. */
export function openSave(what: What): void {
  wanted.value = what;
  dialog.value = "save";
}
