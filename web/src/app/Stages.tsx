// The stage, or the stages, that the mode has.

import { computed, signal } from "@preact/signals";
import { game } from "../predict/overlay";
import { RaceStages } from "../race/RaceStages";
import { marks } from "../see/marks";
import { overlays } from "../see/overlays";
import type { Camera } from "../stage/camera";
import { Stage } from "../stage/Stage";
import { emptyScene, type StageScene, sceneOfDrawing } from "../stage/scene";
import { drawing, recipe } from "../state/drawing";
import { mesh } from "../state/mesh";
import { mode } from "../state/mode";
import { frame } from "../state/play";

const camera = signal<Camera | null>(null);

/** What the stage shows: a mesh, a run, or the bare drawing. */
const scene = computed<StageScene>(() => {
  const drawn = drawing.value;
  if (!drawn) return emptyScene;
  const bare = sceneOfDrawing(drawn.points, drawn.segments);
  return (mode.value === "mesh" ? ofMesh() : ofRun()) ?? bare;
});

/** What `fit` brings into view: all that was drawn. */
const whole = computed(() => drawing.value?.points ?? emptyScene.points);

/** What the drawing comes from; while it is only edited the view stays. */
const source = computed(() => drawing.value && recipe.peek().source);

function ofRun(): StageScene | null {
  if (!frame.value) return null;
  const { points, edges, locked, triangles } = frame.value;
  return { points, edges, locked, triangles, values: null, hasDots: true };
}

function ofMesh(): StageScene | null {
  if (!mesh.value) return null;
  const { points, edges, triangles } = mesh.value;
  return { points, edges, locked: null, triangles, values: null, hasDots: false };
}

/** In the game marks would tell too much. */
const drawn = computed(() =>
  mode.value === "predict" ? [...overlays.value.filter((each) => each !== marks), game] : overlays.value,
);

export function Stages() {
  if (mode.value === "race") return <RaceStages camera={camera} whole={whole} source={source} />;
  return <Stage scene={scene} overlays={drawn} camera={camera} whole={whole} source={source} />;
}
