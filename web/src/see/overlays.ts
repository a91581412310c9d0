// What can be shown over the scene. Each overlay is a room of its own; here is the list of them.

import { computed, signal } from "@preact/signals";
import type { Overlay } from "../stage/Stage";
import { mode } from "../state/mode";
import type { Words } from "../words";
import { marks } from "./marks";

/** Names an overlay that can be switched on and off: a key of the words of this room. */
export type SeeName = keyof Words["see"];

export interface Seen {
  name: SeeName;
  /** In which modes it has something to show. */
  modes: (typeof mode.value)[];
  overlay: Overlay;
}

/** All that can be switched, in the order in which it is drawn. */
export const all: Seen[] = [];

/** The names of those that are switched on. */
export const switched = signal<ReadonlySet<SeeName>>(new Set());

/** What is drawn over the scene now. */
export const overlays = computed<Overlay[]>(() => {
  const on = all.filter(({ name, modes }) => switched.value.has(name) && modes.includes(mode.value));
  const always = mode.value === "mesh" ? [] : [marks];
  return [...on.map(({ overlay }) => overlay), ...always];
});
