// The run on the stage: which algorithm, where it stands, and the scene there.

import { batch, computed, effect, signal } from "@preact/signals";
import { type Engine, stage } from "../engine/client";
import type { Algorithm, Direction, Frame, NamedBytes, Run, RunOptions, Source } from "../engine/protocol";
import { active, forgetLines, type Stopped, stopped } from "./breakpoints";
import { drawing, open, recipe } from "./drawing";
import { follow } from "./follow";
import { isDrawing, jobOf, work } from "./job";
import { type Mode, mode } from "./mode";
import { tell } from "./notices";
import { language } from "./settings";

/** The slot of the run on the stage; races use those from 1 on. */
export const SLOT = 0;

/** All algorithms that can be played. */
export const algorithms = signal<Algorithm[]>([]);

/** The name of the algorithm that is chosen, and what it wants to know. */
export const chosen = signal("sweep");
export const options = signal<RunOptions>({ seed: 1 });

export const algorithm = computed(() => algorithms.value.find((each) => each.name === chosen.value));

/** The run; null while there is none. */
export const run = signal<Run | null>(null);

/** The run; while another one is made, the one before: so that panels do not flicker. */
export const shownRun = signal<Run | null>(null);

/** Where it is to stand, and the scene that is shown: on its way there, a step behind at most. */
export const position = signal(0);
export const frame = signal<Frame | null>(null);

/** Whether it plays, which way, and how many steps a second; infinitely many: as fast as it goes. */
export const isPlaying = signal(false);
export const heading = signal<Direction>("next");
export const speed = signal(8);

/** The log that is played instead of a run that was made here. */
let log: NamedBytes | null = null;

// A new worker knows nothing.
stage.onRestart(async (engine) => {
  if (drawing.peek()) await engine.drawings.make(recipe.peek());
  const lost = run.peek();
  if (lost && log) await engine.players.open(SLOT, log);
  else if (lost) await engine.players.run(SLOT, lost.algorithm, options.peek());
});

/** Counts how often a run was asked for. */
let call = 0;

/** Runs the chosen algorithm on the drawing, and stands at `at`, or at the end if that is nearer. */
export async function start(at = 0): Promise<void> {
  const asked = follower.accept();
  call += 1;
  const mine = call;
  isPlaying.value = false;
  run.value = null;
  log = null;
  const [what, how, said] = [chosen.peek(), options.peek(), language.peek()];
  const made = await work(stage, "run", async (engine, progress) => {
    const run = await engine.players.run(SLOT, what, how, progress);
    const place = Math.min(at, run.length);
    return { run, frame: await engine.players.frame(SLOT, place, said) };
  });
  // Cancelled, perhaps by other work: whoever comes back to play gets it.
  if (!made) follower.forget(asked);
  // What is shown stays if there is more to come: another call, or another drawing.
  if (!made && (call !== mine || isDrawing.peek())) return;
  batch(() => {
    run.value = made?.run ?? null;
    shownRun.value = run.value;
    frame.value = made?.frame ?? null;
    position.value = made?.frame.position ?? 0;
  });
}

/** Whether the drawing of a log is being made: its run is there already. */
const isAdopting = signal(false);

/** Plays the log of a run, on a drawing of what it began with; returns whether that went well. */
export async function playLog(file: NamedBytes): Promise<boolean> {
  const made = await work(stage, "run", (engine) => engine.players.open(SLOT, file));
  if (!made) return false;
  isAdopting.value = true;
  try {
    if (!watched.includes(mode.peek())) mode.value = "play";
    const frames = [0, made.length].map((at) =>
      stage.ask((engine) => engine.players.frame(SLOT, at, language.peek())),
    );
    const [first, last] = await Promise.all(frames);
    if (!(await open(beginningOf(first, last)))) return false;
    if (algorithms.peek().some(({ name }) => name === made.algorithm)) chosen.value = made.algorithm;
  } catch (error) {
    tell(error);
    return false;
  } finally {
    isAdopting.value = false;
  }
  log = file;
  follower.accept();
  batch(() => {
    run.value = made;
    shownRun.value = made;
    frame.value = null;
    position.value = 0;
  });
  return true;
}

/** Returns what a run began with: the points of its first scene, and the constraints between them of its last. */
function beginningOf({ points }: Frame, { edges, locked }: Frame): Source {
  const count = points.length / 2;
  const segments: number[] = [];
  for (let e = 0; e < edges.length; e += 2) {
    const [a, b] = [edges[e], edges[e + 1]];
    if (locked[e / 2] === 1 && a < count && b < count) segments.push(a, b);
  }
  return { kind: "lists", points, segments: Uint32Array.from(segments), holes: new Float64Array() };
}

/** Goes to a position, which may lie outside of the run. */
export function seek(to: number): void {
  const length = run.value?.length ?? 0;
  position.value = Math.max(0, Math.min(Math.round(to), length));
}

/** Whether a drawing, or the run itself, is being made. */
const isUnderWay = computed(
  () => isDrawing.value || isAdopting.value || (run.value === null && jobOf(stage).value !== null),
);

/** Whether there will soon be another run: what it is made of is on its way, or has changed just now. */
const isComing = (): boolean => isUnderWay.peek() || follower.isDue();

/** Fulfilled when no run is to come any more. */
async function arrival(): Promise<void> {
  while (isComing()) {
    let stop = () => {};
    await new Promise<void>((done) => {
      stop = effect(() => {
        if (!isUnderWay.value) done();
      });
    });
    stop();
    // Between the end of the drawing's job and the beginning of the run's there is none: look again after that.
    await new Promise((next) => setTimeout(next));
  }
}

/** What all wait for who have come while a run was being made. */
let coming: Promise<void> | null = null;

/** Waits for the run that is being made, if one is. */
function there(): Promise<void> {
  coming ??= arrival().finally(() => {
    coming = null;
  });
  return coming;
}

/** Does something with the run: what is asked for while another one is made is meant for that, and is done in turn. */
export function whenThere(act: () => void): void {
  if (coming || isComing()) void there().then(act);
  else act();
}

/** Goes to the next, or the previous, position behind a step of this kind; to the end, or the beginning, if there is none. */
export async function jump(direction: Direction, kind: string): Promise<void> {
  await there();
  const [from, end] = [position.value, direction === "next" ? (run.value?.length ?? 0) : 0];
  const found = await stage.ask((engine) => engine.players.find(SLOT, direction, kind, from)).catch(tell);
  seek(found ?? end);
}

/** Finds where the next breakpoint that is on stops the run; null if none does. */
export async function nextStop(direction: Direction, from: number): Promise<Stopped | null> {
  const wanted = active.peek();
  if (wanted.length === 0 || !run.peek()) return null;
  const conditions = wanted.map(({ condition }) => condition);
  const found = await stage.ask((engine) =>
    engine.players.stop(SLOT, conditions, from, direction === "previous"),
  );
  return found ? { position: found.position, breakpoint: wanted[found.which] } : null;
}

/** Goes to the next, or the previous, breakpoint; to the end, or the beginning, if there is none. */
export async function jumpToStop(direction: Direction): Promise<void> {
  isPlaying.value = false;
  await there();
  try {
    const found = await nextStop(direction, position.peek());
    stopped.value = found;
    seek(found?.position ?? (direction === "next" ? (run.peek()?.length ?? 0) : 0));
  } catch (error) {
    tell(error);
  }
}

/** Asks something about the run on the stage. */
export const askRun = <T>(
  question: (engine: Pick<Engine, "players" | "looks">, slot: number) => Promise<T>,
): Promise<T> => stage.ask((engine) => question(engine, SLOT));

// A drawing or an algorithm that changes makes another run; where nobody watches one, not before somebody comes back.
const watched: Mode[] = ["play", "predict"];
const follower = follow(
  () =>
    drawing.value && algorithms.value.length > 0 && watched.includes(mode.value)
      ? [drawing.value, chosen.value, options.value]
      : null,
  computed(() => isDrawing.value || isAdopting.value),
  () => void start(place()),
);

// While a drawing is edited, or an option turned, the run stands where it stood: at its end, or so far.
let shown: unknown[] = [];
function place(): number {
  const [before, now] = [shown, [recipe.peek().source, chosen.peek()]];
  shown = now;
  if (now.some((part, i) => part !== before[i])) {
    frame.value = null;
    return 0;
  }
  const last = frame.peek()?.position ?? 0;
  return last > 0 && last === shownRun.peek()?.length ? Number.POSITIVE_INFINITY : last;
}

// Lines of another algorithm are others.
effect(() => {
  void chosen.value;
  forgetLines();
});

// The scene follows the position: one question at a time, and then for where it stands by now.
let isLooking = false;
effect(() => {
  void [position.value, language.value];
  if (run.value && !isLooking) void look();
});

async function look(): Promise<void> {
  isLooking = true;
  try {
    for (;;) {
      const [of, at, words] = [run.peek(), position.peek(), language.peek()];
      if (!of) return;
      const seen = await stage.ask((engine) => engine.players.frame(SLOT, at, words));
      if (run.peek() !== of) continue;
      frame.value = seen;
      if (position.peek() === at && language.peek() === words) return;
    }
  } catch (error) {
    tell(error);
  } finally {
    isLooking = false;
  }
}
