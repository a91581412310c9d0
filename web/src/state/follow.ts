// Doing something whenever something else has changed: once for changes that come together, and not too early.

import { effect, type ReadonlySignal, untracked } from "@preact/signals";

/** Values that are followed; null: nothing is to be done now. */
type Values = unknown[] | null;

export interface Follower {
  /** Tells whether something has changed, so that `act` may be about to be called. */
  isDue(): boolean;
  /** Takes the values as they are for known, since somebody has acted already; returns them. */
  accept(): Values;
  /** Forgets values that were accepted, since what came of them is lost, unless there are newer ones. */
  forget(accepted: Values): void;
}

/** Calls `act` soon after a value has changed that `read` lists; while `isBusy`, not before that is over. */
export function follow(read: () => Values, isBusy: ReadonlySignal<boolean>, act: () => void): Follower {
  let known: Values = null;
  let isDue = false;
  const check = () => {
    isDue = false;
    const now = untracked(read);
    const isKnown = now?.every((value, i) => value === known?.[i]) ?? true;
    if (!isKnown && !isBusy.peek()) act();
  };
  effect(() => {
    void [read(), isBusy.value];
    if (!isDue) setTimeout(check);
    isDue = true;
  });
  return {
    isDue: () => isDue,
    accept() {
      known = untracked(read);
      return known;
    },
    forget(accepted) {
      if (known === accepted) known = null;
    },
  };
}
