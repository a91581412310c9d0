// What has happened since the turn began that is under way: what several overlays show parts of.

import { computed } from "@preact/signals";
import { stage } from "../engine/client";
import type { Happening } from "../engine/protocol";
import { mode } from "../state/mode";
import { frame, run, SLOT } from "../state/play";
import { isLifted, type SeeName, switched } from "../state/see";
import { asked } from "./asking";

const users: SeeName[] = ["walk", "circle", "rays", "encroached"];

/** Tells whether something of the run is looked at: in the mode that plays, with one of these switched on. */
export const looksAt = (...names: SeeName[]): boolean =>
  mode.value === "play" && names.some((name) => switched.value.has(name));

/** The same of the mesh. */
export const looksAtMesh = (...names: SeeName[]): boolean =>
  mode.value === "mesh" && names.some((name) => switched.value.has(name));

/** The run and the position of the scene that is shown; null if there is none. */
export const standing = computed(() => {
  if (!run.value || !frame.value) return null;
  return { of: run.value, position: frame.value.position };
});

const known = asked(
  stage,
  () => (looksAt(...users) || (isLifted.value && mode.value === "play") ? standing.value : null),
  (engine, { position }) => engine.looks.turn(SLOT, position),
);

/** What has happened in this turn, oldest first. */
export const turn = computed<Happening[]>(() => known.value ?? []);
