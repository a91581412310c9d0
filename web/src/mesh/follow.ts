// Quick meshes follow the drawing and what is asked for by themselves.

import { computed, effect } from "@preact/signals";
import { mesher } from "../engine/client";
import { drawing } from "../state/drawing";
import { jobOf } from "../state/job";
import { asked, build, isBusy, isOther, isOutdated, mesh } from "../state/mesh";
import { mode } from "../state/mode";
import { expected } from "./sizes";

/** How long the last mesh may have taken, in milliseconds, and how many triangles the next one may have. */
const QUICK = 300;
const FEW = 200_000;

/** Milliseconds after which it is better to end a worker that makes what nobody asks for any more than to wait for it. */
const PATIENCE = 1000;

/** Whether the mesh follows by itself. */
export const follows = computed(
  () => mesh.value !== null && mesh.value.milliseconds < QUICK && (expected.value ?? 0) < FEW,
);

/** The mesh that is shown: one that is older than the drawing, and will not follow, would hide what is being drawn. */
export const shownMesh = computed(() => (isOutdated.value && !follows.value ? null : mesh.value));

let isFollowing = false;
effect(() => {
  void [asked.value, drawing.value, mode.value];
  if (isFollowing) giveUp();
  else if (!isBusy.peek() && wantsAnother()) void follow();
});

function wantsAnother(): boolean {
  return mode.peek() === "mesh" && follows.peek() && (isOutdated.peek() || isOther.peek());
}

/** One at a time: to end a worker and start another one takes longer than to wait. */
async function follow(): Promise<void> {
  isFollowing = true;
  try {
    let last: unknown;
    do {
      last = asked.peek();
      await build();
    } while (last !== asked.peek() && wantsAnother());
  } finally {
    isFollowing = false;
  }
}

function giveUp(): void {
  const job = jobOf(mesher).peek();
  if (job?.name === "mesh" && performance.now() - job.since > PATIENCE) mesher.cancel();
}
