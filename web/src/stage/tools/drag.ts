// Moving a point or the place of a hole: while it is dragged the drawing follows, at most once a frame and as fast as
// the worker keeps up; for the history it is one edit.

import { signal } from "@preact/signals";
import { stage } from "../../engine/client";
import type { Edit } from "../../engine/protocol";
import { amend, drawing, edit } from "../../state/drawing";
import { jobOf } from "../../state/job";
import type { Under } from "./under";

/** With more points than this the drawing follows only when the drag ends. */
const MOST_LIVE_POINTS = 20_000;

export type Grabbed = Extract<Under, { kind: "point" | "hole" }>;

/** What is dragged, and where it is by now; null: nothing. */
export const dragged = signal<{ what: Grabbed; x: number; y: number } | null>(null);

/** The drag under way, and whether the history has an edit of it already. */
let begun: { isKept: boolean } | null = null;

/** Takes hold of something. */
export function grab(what: Grabbed): void {
  begun = { isKept: false };
  const drawn = drawing.peek()!;
  const [list, at] = what.kind === "point" ? [drawn.points, what.point] : [drawn.holes, what.hole];
  dragged.value = { what, x: list[2 * at], y: list[2 * at + 1] };
}

/** Moves what is held. */
export function dragTo(x: number, y: number): void {
  const held = dragged.peek();
  if (!held || !begun) return;
  dragged.value = { ...held, x, y };
  if (drawing.peek()!.points.length / 2 <= MOST_LIVE_POINTS) follow();
}

/** Lets go where it is now. */
export async function release(): Promise<void> {
  const [held, mine] = [dragged.peek(), begun];
  begun = null;
  if (!held || !mine) return;
  if (!isAt(held)) await send(mine, held);
  if (dragged.peek() === held) dragged.value = null;
}

/** Whether the drawing is to follow in the next frame. */
let isWanted = false;

function follow(): void {
  if (isWanted) return;
  isWanted = true;
  requestAnimationFrame(async () => {
    isWanted = false;
    const [held, mine] = [dragged.peek(), begun];
    if (!held || !mine || isAt(held)) return;
    // Work under way would be ended: later.
    if (jobOf(stage).peek()) return follow();
    await send(mine, held);
    if (begun === mine) follow();
  });
}

async function send(mine: { isKept: boolean }, { what, x, y }: Held): Promise<void> {
  const move: Edit =
    what.kind === "point" ? { movePoint: [what.point, x, y] } : { moveHole: [what.hole, x, y] };
  const isAmended = mine.isKept;
  mine.isKept = true;
  if (!(await (isAmended ? amend(move) : edit(move))) && !isAmended) mine.isKept = false;
}

type Held = NonNullable<typeof dragged.value>;

/** Tells whether the drawing has it where it is. */
function isAt({ what, x, y }: Held): boolean {
  const drawn = drawing.peek()!;
  const [list, at] = what.kind === "point" ? [drawn.points, what.point] : [drawn.holes, what.hole];
  return list[2 * at] === x && list[2 * at + 1] === y;
}
