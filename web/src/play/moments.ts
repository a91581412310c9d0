// What the timeline shows of a run: where flips, insertions and ends of stages are, and where breakpoints stop.

import { effect, signal } from "@preact/signals";
import type { Run } from "../engine/protocol";
import { active } from "../state/breakpoints";
import { tell } from "../state/notices";
import { askRun, run, shownRun } from "../state/play";

/** Into how many stretches a run is divided. */
const STRETCHES = 400;

/** Longer runs are not searched for breakpoints in advance: it would take seconds. */
const LONGEST = 200_000;

/** So many positions are marked for each breakpoint, at most. */
const MOST = 1000;

export const momentKinds = ["flip", "insertion", "stage"] as const;
export type MomentKind = (typeof momentKinds)[number];

/** How often each kind happens in each stretch. */
export const moments = signal<Partial<Record<MomentKind, Uint32Array>>>({});

/** The positions at which breakpoints stop. */
export const ticks = signal<number[]>([]);

effect(() => {
  // Those of the run before stay until there are others.
  if (!shownRun.value) moments.value = {};
  else if (run.value) void count(run.value);
});

effect(() => {
  const of = run.value;
  const conditions = active.value.map(({ condition }) => condition);
  if (!of || conditions.length === 0 || of.length > LONGEST) {
    ticks.value = [];
    return;
  }
  askRun(({ players }, slot) => players.stops(slot, conditions, MOST)).then((found) => {
    const isStill = run.peek() === of && active.peek().length === conditions.length;
    if (isStill) ticks.value = found;
  }, tell);
});

async function count(of: Run): Promise<void> {
  try {
    const found: typeof moments.value = {};
    for (const kind of momentKinds) {
      found[kind] = await askRun(({ players }, slot) => players.moments(slot, kind, STRETCHES));
      if (run.peek() !== of) return;
    }
    moments.value = found;
  } catch (error) {
    tell(error);
  }
}
