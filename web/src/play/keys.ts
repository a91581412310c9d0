// The keys of the transport.

import { modeShortcuts } from "../app/shortcuts";
import { heading, isPlaying, jump, jumpToStop, position, run, seek } from "../state/play";

/** Plays this way; pauses if it does so already. */
export function togglePlaying(way: "next" | "previous"): void {
  const isSo = isPlaying.value && heading.value === way;
  heading.value = way;
  isPlaying.value = !isSo && (run.value?.length ?? 0) > 0;
}

/** Goes a few steps, and stays there. */
export function step(by: number): void {
  isPlaying.value = false;
  seek(position.value + by);
}

/** Goes to a place, and stays there. */
export function go(to: number): void {
  isPlaying.value = false;
  seek(to);
}

/** Kinds of moments to jump to, and the key for each. */
export const jumps = {
  change: "→",
  flip: "F",
  insertion: "I",
  test: "T",
  line: "L",
  stage: "G",
  breakpoint: "B",
} as const;

export type Jump = keyof typeof jumps;

/** Jumps to the next, or the previous, moment of a kind, and stays there. */
export function jumpTo(way: "next" | "previous", kind: Jump): void {
  isPlaying.value = false;
  void (kind === "breakpoint" ? jumpToStop(way) : jump(way, kind));
}

const keys = modeShortcuts.play;
keys.set(" ", () => togglePlaying(isPlaying.value ? heading.value : "next"));
keys.set("Shift+ ", () => togglePlaying(isPlaying.value ? heading.value : "previous"));
keys.set("ArrowRight", () => step(1));
keys.set("ArrowLeft", () => step(-1));
keys.set("Home", () => go(0));
keys.set("End", () => go(run.value?.length ?? 0));
for (const [kind, key] of Object.entries(jumps) as [Jump, string][]) {
  const isChange = kind === "change";
  keys.set(isChange ? "Shift+ArrowRight" : key.toLowerCase(), () => jumpTo("next", kind));
  keys.set(isChange ? "Shift+ArrowLeft" : `Shift+${key.toLowerCase()}`, () => jumpTo("previous", kind));
}
