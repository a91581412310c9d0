// The drawing: the recipe by which it is made, and what came of it.

import { computed, signal } from "@preact/signals";
import { stage } from "../engine/client";
import type { DrawingData, Edit, Recipe, Source } from "../engine/protocol";
import { work } from "./job";

/** The recipe of the drawing that is shown. */
export const recipe = signal<Recipe>({
  source: { kind: "preset", name: "uniform", count: 40, seed: 1 },
  edits: [],
});

/** The drawing that is shown; null until the first one is there. */
export const drawing = signal<DrawingData | null>(null);

/** What people may call it: the name of a preset or of a file. */
export const drawingName = computed(() => nameOf(recipe.value.source));

/** Makes the drawing of a recipe and shows it; returns whether that went well. */
export async function show(next: Recipe): Promise<boolean> {
  const made = await work(stage, "draw", (engine) => engine.drawings.make(next));
  if (!made) return false;
  recipe.value = next;
  drawing.value = made;
  return true;
}

/** Begins with something else. */
export const open = (source: Source): Promise<boolean> => show({ source, edits: [] });

/** Changes the drawing; all of the edits are made, or none. */
export function edit(...edits: Edit[]): Promise<boolean> {
  const { source, edits: before } = recipe.value;
  return show({ source, edits: [...before, ...edits] });
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
