// The drawing: the recipe by which it is made, what came of it, and how it was before.

import { batch, computed, signal } from "@preact/signals";
import { stage } from "../engine/client";
import type { DrawingData, Edit, Recipe, Source } from "../engine/protocol";
import { work } from "./job";

/** How many states are kept to go back to; each is a list of edits that shares them with the next. */
const MOST_STATES = 300;

/** The drawing of a page that was opened without saying which. */
export const usualSource: Source = { kind: "preset", name: "uniform", count: 40, seed: 1 };

/** The recipe of the drawing that is shown. */
export const recipe = signal<Recipe>({ source: usualSource, edits: [] });

/** Where the drawing comes from; the same object as long as it is only edited. */
export const source = computed(() => recipe.value.source);

/** The drawing that is shown; null until the first one is there. */
export const drawing = signal<DrawingData | null>(null);

/** What people may call it: the name of a preset or of a file. */
export const drawingName = computed(() => nameOf(source.value));

const past = signal<Recipe[]>([]);
const future = signal<Recipe[]>([]);

/** Whether there is something to take back, and something to do again. */
export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

// Whatever is done to the drawing is done in turn: what comes too early would end the worker at work on the last.
let turn: Promise<unknown> = Promise.resolve();

/** Does something once all that was asked for before is done. */
export function inTurn<T>(next: () => Promise<T>): Promise<T> {
  const mine = turn.then(next);
  turn = mine.catch(() => {});
  return mine;
}

// What is about to be replaced is not changed any more: that would end the worker that makes the other one.
const changing = (next: () => Promise<boolean>): Promise<boolean> =>
  inTurn(async () => opening === 0 && drawing.peek() !== null && next());

/** Somebody's wish to see another drawing. Only the last one counts, however long it takes until it can be fulfilled. */
type Wish = object;
let last: Wish = {};

/** Wishes for another drawing, which is still to be read, unpacked or fetched. */
export function wish(): Wish {
  last = {};
  return last;
}

/** Ends a wish that came to nothing: where nothing is shown yet the usual drawing is. */
export async function giveUp(mine: Wish): Promise<void> {
  if (mine === last && !drawing.peek()) await put({ source: usualSource, edits: [] }, [], []);
}

/** How many drawings are being opened; all but the last one have been cancelled. */
let opening = 0;

/** Makes the drawing of a recipe and shows it, unless somebody wishes for another one; returns whether that went well. */
export async function show(next: Recipe, mine: Wish = wish()): Promise<boolean> {
  if (mine !== last) return false;
  opening += 1;
  try {
    const before = drawing.peek() ? [...past.peek(), recipe.peek()] : [];
    if (await put(next, before, [])) return true;
    await giveUp(mine);
    return false;
  } finally {
    opening -= 1;
  }
}

/** Begins with something else. */
export const open = (source: Source, mine?: Wish): Promise<boolean> => show({ source, edits: [] }, mine);

/** Begins with nothing. */
export const openEmpty = (): Promise<boolean> =>
  open({ kind: "lists", points: new Float64Array(), segments: new Uint32Array(), holes: new Float64Array() });

/** Changes the drawing; all of the edits are made, or none. */
export const edit = (...edits: Edit[]): Promise<boolean> => changing(() => change(edits, false));

/** Changes the drawing by edits that depend on how it is once all that was asked for before is done; by none, too. */
export const editBy = (make: (drawn: DrawingData) => Edit[]): Promise<boolean> =>
  changing(async () => {
    const edits = make(drawing.peek()!);
    return edits.length > 0 && change(edits, false);
  });

/** Changes the drawing by an edit that takes the place of the last one: another position of what is dragged. */
export const amend = (edit: Edit): Promise<boolean> => changing(() => change([edit], true));

/** Takes the last change back. */
export const undo = (): Promise<boolean> =>
  changing(async () => {
    const [states, now] = [past.peek(), recipe.peek()];
    const last = states.at(-1);
    return last !== undefined && put(last, states.slice(0, -1), [now, ...future.peek()]);
  });

/** Makes a change again that was taken back. */
export const redo = (): Promise<boolean> =>
  changing(async () => {
    const [next, ...rest] = future.peek();
    return next !== undefined && put(next, [...past.peek(), recipe.peek()], rest);
  });

async function put(next: Recipe, before: Recipe[], after: Recipe[]): Promise<boolean> {
  const made = await work(stage, "draw", (engine) => engine.drawings.make(next));
  if (made) set(next, made, before, after);
  return made !== undefined;
}

async function change(edits: Edit[], takesPlace: boolean): Promise<boolean> {
  const made = await work(stage, "draw", (engine) => engine.drawings.edit(edits));
  if (!made) return false;
  const { source, edits: before } = recipe.peek();
  const kept = takesPlace ? before.slice(0, -1) : before;
  const states = takesPlace ? past.peek() : [...past.peek(), recipe.peek()];
  set({ source, edits: [...kept, ...edits] }, made, states, []);
  return true;
}

function set(next: Recipe, made: DrawingData, before: Recipe[], after: Recipe[]): void {
  batch(() => {
    recipe.value = next;
    drawing.value = made;
    past.value = before.slice(-MOST_STATES);
    future.value = after;
  });
}

function nameOf(source: Source): string {
  switch (source.kind) {
    case "preset":
      return source.name;
    case "files":
      return source.files[0].name.replace(/\.[^.]*$/, "");
    case "lists":
      return "drawing";
  }
}
