// A race: a few algorithms on the same drawing, each shown where it has used up as much as the others.

import { batch, computed, effect, type Signal, signal } from "@preact/signals";
import { stage } from "../engine/client";
import { type Clock, clocks, type Frame, type Run } from "../engine/protocol";
import { secondsBetween } from "../play/pace";
import { advance, fullTime, MOST, type Totals, usual } from "../race/racing";
import { drawing } from "./drawing";
import { follow } from "./follow";
import { isDrawing, work } from "./job";
import { mode } from "./mode";
import { tell } from "./notices";
import { algorithms, options } from "./play";
import { language } from "./settings";

/** A racer: its run, and what is seen of it. */
export interface Lane {
  /** In the worker; the run on the stage has slot 0. */
  slot: number;
  run: Run;
  totals: Totals;
  frame: Signal<Frame | null>;
}

/** The names of those who race. */
export const racers = signal<string[]>(usual);

/** Those who have been run; none while they are. */
export const lanes = signal<Lane[]>([]);

/** What all have used up, and in which unit. */
export const clock = signal<Clock>("predicates");
export const amount = signal(0);

/** When the last one is at its end. */
export const full = computed(() =>
  fullTime(
    lanes.value.map(({ totals }) => totals),
    clock.value,
  ),
);

/** How many seconds the whole race takes. */
export const duration = signal(12);
export const isRacing = signal(false);

/** Whether all are at their end. */
export const isFinished = computed(() => lanes.value.length > 0 && amount.value >= full.value);

/** Goes to where all have used up so much. */
export function goTo(to: number): void {
  amount.value = Math.max(0, Math.min(to, full.value));
}

/** Changes what the race goes by; all stand as far through it as before. */
export function setClock(next: Clock): void {
  const share = full.value > 0 ? amount.value / full.value : 0;
  batch(() => {
    clock.value = next;
    amount.value = share * full.value;
  });
}

/** Starts the race, or pauses it; at the end it begins again. */
export function toggleRace(): void {
  if (lanes.value.length === 0) return;
  if (!isRacing.value && isFinished.value) amount.value = 0;
  isRacing.value = !isRacing.value;
}

/** Whether racers are being run. */
export const isLiningUp = signal(false);

/** Counts how often racers were called. */
let call = 0;

/** Runs all racers, one after the other, and lines them up. */
export async function lineUp(): Promise<void> {
  const [names, how, asked] = [racers.peek(), options.peek(), follower.accept()];
  call += 1;
  const mine = call;
  batch(() => {
    isRacing.value = false;
    lanes.value = [];
    amount.value = 0;
    isLiningUp.value = true;
  });
  const made = await work(stage, "run", async (engine, progress) => {
    const all: Lane[] = [];
    await engine.players.close(MOST);
    for (const [i, name] of names.entries()) {
      const slot = i + 1;
      const run = await engine.players.run(slot, name, how, progress);
      const used = clocks.map(async (each) => [each, await engine.players.total(slot, each)] as const);
      const totals = Object.fromEntries(await Promise.all(used)) as Totals;
      all.push({ slot, run, totals, frame: signal(null) });
    }
    return all;
  });
  if (call !== mine) return;
  isLiningUp.value = false;
  lanes.value = made ?? [];
  if (!made) follower.forget(asked);
}

// Whoever comes to race lines up; so does everybody when drawing or racers change.
const follower = follow(
  () =>
    drawing.value && algorithms.value.length > 0 && mode.value === "race"
      ? [drawing.value, racers.value, options.value]
      : null,
  isDrawing,
  () => void lineUp(),
);

effect(() => {
  if (mode.value !== "race") isRacing.value = false;
});

// A new worker runs them again.
stage.onRestart(async (engine) => {
  if (mode.peek() !== "race") {
    follower.forget(follower.accept());
    lanes.value = [];
  }
  for (const { slot, run } of lanes.peek()) await engine.players.run(slot, run.algorithm, options.peek());
});

// The scenes follow the clock: one question at a time, and then for what it shows by now.
let isLooking = false;
effect(() => {
  void [amount.value, clock.value, language.value];
  if (lanes.value.length > 0 && !isLooking) void look();
});

async function look(): Promise<void> {
  isLooking = true;
  try {
    for (;;) {
      const state = [lanes.peek(), clock.peek(), amount.peek(), language.peek()] as const;
      const [all, by, used, said] = state;
      for (const lane of all) {
        // Who has no times is shown at its end.
        const isUntold = lane.totals[by] === null;
        const seen = await stage.ask((engine) =>
          isUntold
            ? engine.players.frame(lane.slot, lane.run.length, said)
            : engine.players.frameAt(lane.slot, by, used, said),
        );
        if (lanes.peek() !== all) break;
        lane.frame.value = seen;
      }
      const now = [lanes.peek(), clock.peek(), amount.peek(), language.peek()];
      if (now.every((part, i) => part === state[i])) return;
    }
  } catch (error) {
    tell(error);
  } finally {
    isLooking = false;
  }
}

effect(() => {
  if (!isRacing.value) return;
  let [last, request] = [performance.now(), 0];
  const tick = (now: number) => {
    amount.value = advance(amount.peek(), full.peek(), secondsBetween(last, now), duration.peek());
    last = now;
    if (isFinished.peek()) isRacing.value = false;
    else request = requestAnimationFrame(tick);
  };
  request = requestAnimationFrame(tick);
  return () => cancelAnimationFrame(request);
});
