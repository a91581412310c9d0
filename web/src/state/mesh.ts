// The mesh: what is asked of it, and what came of it. A mesh stays until there is another one, or something else is
// drawn; until then it may be older than the drawing or than what is asked for.

import { batch, computed, effect, signal } from "@preact/signals";
import { type Engine, mesher, told } from "../engine/client";
import type { Measure, MeshData, MeshKind, MeshOptions, Recipe } from "../engine/protocol";
import { counting } from "./asked";
import { recipe, source } from "./drawing";
import { isDrawing, jobOf, work } from "./job";
import { tell } from "./notices";

/** What kind of mesh, and how good. */
export const kind = signal<MeshKind>("refine");
export const options = signal<MeshOptions>({ minAngle: 25 });

/** What triangles are measured by. */
export const measure = signal<Measure>("minAngle");

/** What is asked for. */
interface Asked {
  recipe: Recipe;
  kind: MeshKind;
  options: MeshOptions;
}

/** The options that count; the same object as long as none of them changes. */
let last: MeshOptions = {};
const counted = computed<MeshOptions>(() => {
  const next = counting(kind.value, options.value);
  if (JSON.stringify(next) !== JSON.stringify(last)) last = next;
  return last;
});

/** What is asked for now. */
export const asked = computed<Asked>(() => ({
  recipe: recipe.value,
  kind: kind.value,
  options: counted.value,
}));

/** What the mesh was made of. */
export const made = signal<Asked | null>(null);

/** The mesh; null while there is none. */
export const mesh = signal<MeshData | null>(null);

/** A number for each triangle of the mesh, by the measure that it belongs to. */
export const measured = signal<{ measure: Measure; values: Float32Array } | null>(null);

/** Whether the drawing has changed since the mesh was made. */
export const isOutdated = computed(() => made.value !== null && made.value.recipe !== recipe.value);

/** Whether something else is asked for by now. */
export const isOther = computed(() => {
  const of = made.value;
  return of !== null && (of.kind !== kind.value || of.options !== counted.value);
});

/** Whether a mesh is being made. */
export const isBusy = computed(() => jobOf(mesher).value?.name === "mesh");

let isBuilding = false;

/** Meshes the drawing; whatever mesh is being made is given up. Returns whether that went well. */
export async function build(): Promise<boolean> {
  await drawn();
  const [what, by] = [asked.peek(), measure.peek()];
  isBuilding = true;
  const done = await work(mesher, "mesh", async (engine, progress) => {
    await engine.drawings.keep(what.recipe);
    const data = await engine.meshes.make(what.kind, what.options, progress);
    return { data, values: await engine.meshes.measures(by) };
  });
  isBuilding = isBusy.peek();
  if (!done || source.peek() !== what.recipe.source) return false;
  batch(() => {
    made.value = what;
    mesh.value = done.data;
    measured.value = { measure: by, values: done.values };
  });
  return true;
}

/** Waits until the drawing is there that somebody has chosen. */
async function drawn(): Promise<void> {
  if (!isDrawing.peek()) return;
  let stop = () => {};
  await new Promise<void>((done) => {
    stop = isDrawing.subscribe((is) => {
      if (!is) done();
    });
  });
  stop();
}

/** Asks something about the mesh; `undefined` if that failed, or there is another one by now. */
export async function askMesh<T>(question: (engine: Engine) => Promise<T>): Promise<T | undefined> {
  const of = mesh.peek();
  if (!of) return undefined;
  try {
    const answer = await mesher.ask(question);
    return mesh.peek() === of ? answer : undefined;
  } catch (error) {
    if (mesh.peek() === of) tell(error);
    return undefined;
  }
}

// A worker that was ended has lost the mesh; it is made again when it is asked for, but not only to be replaced.
mesher.onRestart(async (engine) => {
  const lost = made.peek();
  if (!lost || isBuilding) return;
  await engine.drawings.keep(lost.recipe);
  await engine.meshes.make(
    lost.kind,
    lost.options,
    told(() => {}),
  );
});

// A mesh of something else is none of this drawing; one that is only edited keeps it.
effect(() => {
  void source.value;
  batch(() => {
    mesh.value = made.value = measured.value = null;
  });
});

// Another measure is asked for.
effect(() => {
  const [by, now] = [measure.value, measured.value];
  if (!now || now.measure === by) return;
  void askMesh((engine) => engine.meshes.measures(by)).then((values) => {
    if (values && measure.peek() === by) measured.value = { measure: by, values };
  });
});
