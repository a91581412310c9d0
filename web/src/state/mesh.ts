// The mesh: what is asked of it, and what came of it.

import { effect, signal } from "@preact/signals";
import { mesher } from "../engine/client";
import type { MeshData, MeshKind, MeshOptions } from "../engine/protocol";
import { drawing, recipe } from "./drawing";
import { work } from "./job";

/** What kind of mesh, and how good. */
export const kind = signal<MeshKind>("refine");
export const options = signal<MeshOptions>({ minAngle: 25 });

/** The mesh of the drawing; null while there is none. */
export const mesh = signal<MeshData | null>(null);

/** Meshes the drawing. */
export async function build(): Promise<void> {
  const [of, what, how] = [recipe.peek(), kind.peek(), options.peek()];
  const made = await work(mesher, "mesh", async (engine, progress) => {
    await engine.drawings.keep(of);
    return engine.meshes.make(what, how, progress);
  });
  // The worker has given up the mesh before, or has been ended with it.
  if (recipe.peek() === of) mesh.value = made ?? null;
}

// A mesh of something else is none of this drawing.
effect(() => {
  void drawing.value;
  mesh.value = null;
});
