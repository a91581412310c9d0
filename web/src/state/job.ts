// Long work: one job at a time for each worker, with progress, and cancelled at once.

import { computed, type Signal, signal } from "@preact/signals";
import { Cancelled, type Client, type Engine, mesher, stage, told } from "../engine/client";
import type { Progress } from "../engine/protocol";
import { tell } from "./notices";

export interface Job {
  /** What is being done: a key of `words.jobs`. */
  name: "draw" | "run" | "mesh" | "save" | "record";
  phase: string;
  done: number;
  /** 0: nobody knows. */
  total: number;
  /** When it began, as `performance.now` tells. */
  since: number;
}

const running = new Map<Client, Signal<Job | null>>([
  [stage, signal(null)],
  [mesher, signal(null)],
]);

/** The job that is under way in the page itself. */
const here = signal<Job | null>(null);
let stopHere = new AbortController();

/** The job that is under way in a worker; null if there is none. */
export const jobOf = (client: Client): Signal<Job | null> => running.get(client)!;

/** Whether a drawing is being made: other work on the stage would cancel that. */
export const isDrawing = computed(() => running.get(stage)?.value?.name === "draw");

/** All jobs that are under way. */
export const jobs = computed(() =>
  [...running.values(), here].flatMap(({ value }): Job[] => (value ? [value] : [])),
);

/**
 * Does long work in a worker and returns its result; `undefined` if it failed, which has been shown then, or was
 * cancelled. Work that is under way there is cancelled.
 */
export async function work<T>(
  client: Client,
  name: Job["name"],
  question: (engine: Engine, progress: Progress) => Promise<T>,
): Promise<T | undefined> {
  const job = jobOf(client);
  if (job.peek()) client.cancel();
  const mine = { name, phase: "", done: 0, total: 0, since: performance.now() };
  let shown: Job = mine;
  job.value = shown;
  // Messages of a worker that has been ended may still be on their way.
  const progress = told((phase, done, total) => {
    if (job.peek() !== shown) return;
    shown = { ...mine, phase, done, total };
    job.value = shown;
  });
  try {
    return await client.ask((engine) => question(engine, progress));
  } catch (error) {
    tell(error);
    return undefined;
  } finally {
    if (job.peek() === shown) job.value = null;
  }
}

/** Does long work in the page, between its frames, as `work` does in a worker; the signal tells when to stop. */
export async function workHere<T>(
  name: Job["name"],
  task: (signal: AbortSignal, progress: Progress) => Promise<T>,
): Promise<T | undefined> {
  stopHere.abort(new Cancelled());
  const mine = new AbortController();
  stopHere = mine;
  const begun: Job = { name, phase: "", done: 0, total: 0, since: performance.now() };
  here.value = begun;
  try {
    return await task(mine.signal, (phase, done, total) => {
      if (stopHere === mine) here.value = { ...begun, phase, done, total };
    });
  } catch (error) {
    tell(error);
    return undefined;
  } finally {
    if (stopHere === mine) here.value = null;
  }
}

/** Ends all jobs that are under way. */
export function cancelJobs(): void {
  stopHere.abort(new Cancelled());
  for (const [client, job] of running) if (job.peek()) client.cancel();
}
