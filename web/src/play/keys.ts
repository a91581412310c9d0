// The keys of the transport.

import { bind } from "../app/shortcuts";
import { heading, isPlaying, jump, jumpToStop, position, run, seek, whenThere } from "../state/play";

/** Plays this way; pauses if it does so already. */
export function togglePlaying(way: "next" | "previous"): void {
  const isSo = isPlaying.value && heading.value === way;
  heading.value = way;
  if (isSo) isPlaying.value = false;
  else
    whenThere(() => {
      isPlaying.value = (run.peek()?.length ?? 0) > 0;
    });
}

/** Goes a few steps, and stays there. */
export function step(by: number): void {
  isPlaying.value = false;
  whenThere(() => seek(position.peek() + by));
}

/** Goes to a place, and stays there. */
export function go(to: number): void {
  isPlaying.value = false;
  whenThere(() => seek(to));
}

/** Goes to the end, and stays there: to that of the run that comes, where the one before may be shorter. */
export const goToEnd = (): void => go(Number.POSITIVE_INFINITY);

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

bind("play", " ", "playPause", () => togglePlaying(isPlaying.value ? heading.value : "next"));
bind("play", "Shift+ ", "playBackwards", () => togglePlaying(isPlaying.value ? heading.value : "previous"));
bind("play", "ArrowRight", "next", () => step(1));
bind("play", "ArrowLeft", "previous", () => step(-1));
bind("play", "Home", "first", () => go(0));
bind("play", "End", "last", goToEnd);
for (const [kind, key] of Object.entries(jumps) as [Jump, string][]) {
  const letter = key.toLowerCase();
  const isChange = kind === "change";
  const [next, previous] = isChange ? ["Shift+ArrowRight", "Shift+ArrowLeft"] : [letter, `Shift+${letter}`];
  bind("play", next, kind, () => jumpTo("next", kind));
  bind("play", previous, kind, () => jumpTo("previous", kind));
}
