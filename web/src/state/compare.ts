// All algorithms on one drawing: what each of them counts.

import { effect, signal } from "@preact/signals";
import { stage } from "../engine/client";
import type { Measured } from "../engine/protocol";
import { drawing } from "./drawing";
import { work } from "./job";
import { algorithms, options } from "./play";

/** Points beyond which the slower ones would take all day. */
export const MOST_POINTS = 2000;

/** An algorithm: what it counted, or why it could not. */
export interface Entry {
  name: string;
  title: string;
  measured: Measured | null;
  error: string;
}

export const entries = signal<Entry[]>([]);
export const isComparing = signal(false);

/** The name of the library's triangulation of the points; null: not known. */
export const libraryHash = signal<string | null>(null);

/** Runs all algorithms, one after the other. */
export async function compare(): Promise<void> {
  const [all, how] = [algorithms.peek(), options.peek()];
  entries.value = [];
  libraryHash.value = null;
  isComparing.value = true;
  await work(stage, "run", async (engine, progress) => {
    libraryHash.value = await engine.players.libraryHash();
    for (const [done, { name, title }] of all.entries()) {
      progress(name, done, all.length);
      let [measured, error]: [Measured | null, string] = [null, ""];
      try {
        measured = await engine.players.measure(name, how);
      } catch (reason) {
        // One that cannot do it is no reason to stop; a module that is broken is.
        if (reason instanceof Error && reason.name === "RuntimeError") throw reason;
        error = reason instanceof Error ? reason.message : String(reason);
      }
      entries.value = [...entries.peek(), { name, title, measured, error }];
    }
  });
  isComparing.value = false;
}

// Figures of another drawing are none of this one.
effect(() => {
  void drawing.value;
  entries.value = [];
  libraryHash.value = null;
});
