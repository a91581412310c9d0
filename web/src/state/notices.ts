// What has gone wrong, or is worth a word, until somebody dismisses it.

import { signal } from "@preact/signals";
import { Cancelled } from "../engine/client";
import type { Marks } from "../engine/protocol";
import { marksOf } from "../engine/troubles";
import { inWords } from "../words/errors";

export interface Notice {
  id: number;
  tone: "error" | "info";
  text: string;
  /** Where the trouble is, to be marked on the stage. */
  marks?: Marks | undefined;
  /** Something that may be done about it: a key of `words.app.actions`. */
  action?: NoticeAction | undefined;
}

export interface NoticeAction {
  name: "save";
  run(): void;
}

export const notices = signal<Notice[]>([]);

let last = 0;

/** Shows a notice. */
export function notify(
  tone: Notice["tone"],
  text: string,
  more: Pick<Notice, "marks" | "action"> = {},
): void {
  const others = notices.value.filter((notice) => notice.text !== text);
  last += 1;
  notices.value = [...others, { id: last, tone, text, ...more }].slice(-4);
}

/** Takes a notice away. */
export function dismiss(id: number): void {
  notices.value = notices.value.filter((notice) => notice.id !== id);
}

/** Takes away all notices that mark something: it has changed. */
export function dismissMarks(): void {
  if (notices.peek().some(({ marks }) => marks)) {
    notices.value = notices.peek().filter(({ marks }) => !marks);
  }
}

/** Shows why something failed; that it was cancelled is no failure. */
export function tell(error: unknown): void {
  if (error instanceof Cancelled) return;
  notify("error", inWords(error instanceof Error ? error.message : String(error)), { marks: marksOf(error) });
}
