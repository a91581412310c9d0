// The run on the stage: which algorithm, where it stands, and the scene there.

import { batch, computed, effect, signal } from "@preact/signals";
import { stage } from "../engine/client";
import type { Algorithm, Direction, Frame, NamedBytes, Run, RunOptions, Source } from "../engine/protocol";
import { drawing, open, recipe } from "./drawing";
import { work } from "./job";
import { mode } from "./mode";
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

/** Where it is to stand, and the scene that is shown: on its way there, a step behind at most. */
export const position = signal(0);
export const frame = signal<Frame | null>(null);

/** Whether it plays, and how many steps a second. */
export const isPlaying = signal(false);
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

/** Runs the chosen algorithm on the drawing, and stands at `at`. */
export async function start(at = 0): Promise<void> {
  isPlaying.value = false;
  run.value = null;
  log = null;
  const made = await work(stage, "run", (engine) => engine.players.run(SLOT, chosen.peek(), options.peek()));
  batch(() => {
    run.value = made ?? null;
    if (!made) frame.value = null;
    position.value = Math.min(at, made?.length ?? 0);
  });
}

/** Plays the log of a run, on a drawing of what it began with; returns whether that went well. */
export async function playLog(file: NamedBytes): Promise<boolean> {
  const made = await work(stage, "run", (engine) => engine.players.open(SLOT, file));
  if (!made) return false;
  isAdopting = true;
  try {
    if (mode.peek() === "mesh") mode.value = "play";
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
    isAdopting = false;
  }
  log = file;
  batch(() => {
    run.value = made;
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

/** Goes to the next, or the previous, position behind a step of this kind; to the end, or the beginning, if there is none. */
export async function jump(direction: Direction, kind: string): Promise<void> {
  const [from, end] = [position.value, direction === "next" ? (run.value?.length ?? 0) : 0];
  const found = await stage.ask((engine) => engine.players.find(SLOT, direction, kind, from)).catch(tell);
  seek(found ?? end);
}

// A drawing or an algorithm that changes makes another run. While the drawing is only edited, it stands where the one
// before stood, and at the end if that did; whatever else is drawn is seen bare until its run is there.
let wanted: unknown[] = [];
let isAdopting = false;
/** Where it stood when the last edit came: edits may come faster than runs. */
let ended = 0;
effect(() => {
  const next = [drawing.value, chosen.value, options.value, recipe.value.source];
  if (!drawing.value || algorithms.value.length === 0) return;
  if (next.slice(0, 3).every((part, i) => part === wanted[i])) return;
  // Whoever meshes a million points does not want to watch, step by step, how that is done.
  if (mode.value === "mesh") return forget();
  const isEdited = next.slice(1).every((part, i) => part === wanted[i + 1]);
  wanted = next;
  if (!isEdited) frame.value = null;
  if (!isAdopting) void start(isEdited ? standing() : 0);
});

/** Gives up a run that is of something else by now. */
function forget(): void {
  batch(() => {
    run.value = null;
    frame.value = null;
  });
}

function standing(): number {
  const [at, length] = [position.peek(), run.peek()?.length];
  if (length === undefined) return ended;
  ended = at === length ? Number.POSITIVE_INFINITY : at;
  return ended;
}

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
