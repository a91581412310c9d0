// What has gone wrong, or is worth a word, until somebody dismisses it.

import { signal } from "@preact/signals";
import { Cancelled } from "../engine/client";

export interface Notice {
  id: number;
  tone: "error" | "info";
  text: string;
}

export const notices = signal<Notice[]>([]);

let last = 0;

/** Shows a notice. */
export function notify(tone: Notice["tone"], text: string): void {
  const others = notices.value.filter((notice) => notice.text !== text);
  last += 1;
  notices.value = [...others, { id: last, tone, text }].slice(-4);
}

/** Takes a notice away. */
export function dismiss(id: number): void {
  notices.value = notices.value.filter((notice) => notice.id !== id);
}

/** Shows why something failed; that it was cancelled is no failure. */
export function tell(error: unknown): void {
  if (error instanceof Cancelled) return;
  notify("error", error instanceof Error ? error.message : String(error));
}
