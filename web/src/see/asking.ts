// Questions to a worker about what is shown: one at a time, never while a job runs there, and only while somebody
// looks. The answer before stays until the next one is there, so that nothing flickers while a run plays; an answer
// about another run is dropped.

import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import type { Client, Engine } from "../engine/client";
import { jobOf } from "../state/job";
import { tell } from "../state/notices";
import { isSame } from "./same";

/** What is asked about. */
export interface Wanted {
  /** The run or the mesh. */
  readonly of: object;
}

/** Keeps an answer to what is wanted; null while nothing is, or nothing is known of this run. */
export function asked<Want extends Wanted, Answer>(
  client: Client,
  wanted: () => Want | null,
  question: (engine: Engine, want: Want) => Promise<Answer>,
): ReadonlySignal<Answer | null> {
  const known = signal<{ of: object; answer: Answer } | null>(null);
  let isAsking = false;

  const ask = async () => {
    isAsking = true;
    try {
      for (let want = untracked(wanted); want && !jobOf(client).peek(); ) {
        const { of } = want;
        const asking = want;
        const answer = await client.ask((engine) => question(engine, asking));
        const now = untracked(wanted);
        if (now?.of === of) known.value = { of, answer };
        if (now === null || isSame(want, now)) return;
        want = now;
      }
    } catch (error) {
      tell(error);
    } finally {
      isAsking = false;
    }
  };

  effect(() => {
    const want = wanted();
    const isFree = jobOf(client).value === null;
    if (known.peek()?.of !== want?.of) known.value = null;
    if (want && isFree && !isAsking) void ask();
  });
  return computed(() => known.value?.answer ?? null);
}
