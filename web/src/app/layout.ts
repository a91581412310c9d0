// How the page is laid out: by the room there is, and by what its reader has folded away.

import { computed, effect, type Signal, signal } from "@preact/signals";
import { all } from "../see/overlays";
import { mode } from "../state/mode";
import { kept } from "../state/settings";

/**
 * wide: panels at both sides of the stage. tall: panels below the stage, beside each other. phone: one panel at a time,
 * below the stage. low: one panel at a time, beside the stage.
 */
export type Size = "wide" | "tall" | "phone" | "low";

/** Below this width there is no room for two panels beside each other; below that one, none at both sides. */
const NARROW = "44rem";
const MIDDLING = "60rem";
/** Below this height nothing fits below the stage. */
const LOW = "32rem";

const isNarrow = watched(`(max-width: ${NARROW})`);
const isMiddling = watched(`(max-width: ${MIDDLING})`);
const isLow = watched(`(max-height: ${LOW}) and (min-width: 36rem)`);

export const size = computed<Size>(() => {
  if (isLow.value) return "low";
  if (isNarrow.value) return "phone";
  return isMiddling.value ? "tall" : "wide";
});

/** Whether there is room for one panel at a time only. */
export const isSingle = computed(() => size.value === "phone" || size.value === "low");

/** The panels; `work` is that of the mode. */
export const panels = ["work", "drawing", "see"] as const;
export type Panel = (typeof panels)[number];

/** Which panels there are in the mode. */
export const panelsHere = computed<Panel[]>(() =>
  panels.filter((panel) => panel !== "see" || all.some(({ modes }) => modes.includes(mode.value))),
);

/** The panel that is open where there is one at a time; null: the stage has all the room. */
export const openPanel = signal<Panel | null>("work");

/** Whether the panels at the left and at the right are there, where there is room for both. */
export const hasLeft = kept("left", "shown", ["shown", "folded"]);
export const hasRight = kept("right", "shown", ["shown", "folded"]);

/** Folds a panel away, or unfolds it. */
export function toggle(which: Signal<"shown" | "folded">): void {
  which.value = which.value === "shown" ? "folded" : "shown";
}

/** Tells whether a panel is to be seen. */
export function isSeen(panel: Panel): boolean {
  if (isSingle.value) return openPanel.value === panel;
  return (panel === "work" ? hasRight : hasLeft).value === "shown";
}

// Where there is little room the game and the race have all that is needed below the stage, and want that large.
effect(() => {
  openPanel.value = mode.value === "play" || mode.value === "mesh" ? "work" : null;
});

/** A signal that tells whether a media query holds. */
function watched(query: string): Signal<boolean> {
  const list = matchMedia(query);
  const holds = signal(list.matches);
  list.addEventListener("change", () => {
    holds.value = list.matches;
  });
  return holds;
}
