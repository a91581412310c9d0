// What is shown over the stage, kept from visit to visit.

import { effect, type Signal, signal } from "@preact/signals";
import type { Words } from "../words";
import { read, write } from "./settings";

/** Names something that can be shown: a key of its words. */
export type SeeName = keyof Words["see"]["names"];

const KEY = "delone.see";

/** What explains the algorithm that runs is shown unless somebody wants it otherwise. */
const usual: SeeName[] = [
  "marks",
  "circle",
  "walk",
  "waiting",
  "front",
  "sweep",
  "rays",
  "encroached",
  "clusters",
];

/** The names of what is switched on. */
export const switched: Signal<ReadonlySet<SeeName>> = signal(new Set(kept() ?? usual));

effect(() => write(KEY, JSON.stringify([...switched.value])));

/** Whether the lifted scene stands beside the stage. */
export const isLifted = signal(false);

/** Switches something on or off. */
export function toggle(name: SeeName): void {
  const next = new Set(switched.value);
  if (!next.delete(name)) next.add(name);
  switched.value = next;
}

/** Switches everything as it is for somebody who comes for the first time. */
export function reset(): void {
  switched.value = new Set(usual);
}

/** Reads what was kept; names that nobody knows are harmless. */
function kept(): SeeName[] | null {
  try {
    const names = JSON.parse(read(KEY) ?? "null");
    return Array.isArray(names) ? names : null;
  } catch {
    return null;
  }
}
