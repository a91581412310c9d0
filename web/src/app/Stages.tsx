// The stage, or the stages, that the mode has.

import { computed, signal } from "@preact/signals";
import { drawn } from "../drawing/drawn";
import { shades } from "../mesh/colours";
import { follows } from "../mesh/follow";
import { inspection } from "../mesh/overlay";
import { overlays } from "../see/overlays";
import type { Camera } from "../stage/camera";
import { Stage } from "../stage/Stage";
import { emptyScene, type StageScene, sceneOfDrawing } from "../stage/scene";
import { drawing, source } from "../state/drawing";
import { isOutdated, mesh } from "../state/mesh";
import { mode } from "../state/mode";
import { frame, run } from "../state/play";

/** Which part of the plane the stage shows; null: all that was drawn. */
export const camera = signal<Camera | null>(null);

/** What the stage shows: a mesh, a run, or the bare drawing. */
export const scene = computed<StageScene>(() => {
  const drawn = drawing.value;
  if (!drawn) return emptyScene;
  const bare = sceneOfDrawing(drawn.points, drawn.segments);
  return (mode.value === "mesh" ? ofMesh() : ofRun()) ?? bare;
});

/** What `fit` brings into view: all that was drawn. */
export const whole = computed(() => drawing.value?.points ?? emptyScene.points);

function ofRun(): StageScene | null {
  // The run before is gone before its last frame is.
  if (!run.value || !frame.value) return null;
  const { points, edges, locked, triangles } = frame.value;
  return { points, edges, locked, triangles, values: null, hasDots: true };
}

function ofMesh(): StageScene | null {
  // One that will not follow by itself would hide what is being drawn.
  if (!mesh.value || (isOutdated.value && !follows.value)) return null;
  const { points, edges, locked, triangles } = mesh.value;
  return { points, edges, locked, triangles, values: shades.value, hasDots: false };
}

/** What is drawn over the scene: what explains it, and the drawing that is being edited. */
export const above = computed(() => [
  ...overlays.value,
  drawn,
  ...(mode.value === "mesh" ? [inspection] : []),
]);

export function Stages() {
  return <Stage scene={scene} overlays={above} camera={camera} whole={whole} source={source} />;
}
