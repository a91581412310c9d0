// The stage, or the stages, that the mode has.

import { computed, signal } from "@preact/signals";
import { drawn } from "../drawing/drawn";
import { Beside } from "../lift/Beside";
import { shades } from "../mesh/colours";
import { shownMesh } from "../mesh/follow";
import { inspection } from "../mesh/overlay";
import { game } from "../predict/overlay";
import { RaceStages } from "../race/RaceStages";
import { overlays } from "../see/overlays";
import type { Camera } from "../stage/camera";
import { type Overlay, Stage } from "../stage/Stage";
import { emptyScene, type StageScene, sceneOfDrawing } from "../stage/scene";
import { drawing, source } from "../state/drawing";
import { type Mode, mode } from "../state/mode";
import { frame } from "../state/play";

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
  if (!frame.value) return null;
  const { points, edges, locked, triangles } = frame.value;
  return { points, edges, locked, triangles, values: null, hasDots: true };
}

function ofMesh(): StageScene | null {
  if (!shownMesh.value) return null;
  const { points, edges, locked, triangles } = shownMesh.value;
  return { points, edges, locked, triangles, values: shades.value, hasDots: false };
}

/** What the mode draws over everything else. */
const ofMode: Partial<Record<Mode, Overlay>> = { predict: game, mesh: inspection };

/** What is drawn over the scene: what explains it, and the drawing that is being edited. */
export const above = computed<Overlay[]>(() => [...overlays.value, drawn, ofMode[mode.value] ?? []].flat());

export function Stages() {
  if (mode.value === "race") return <RaceStages camera={camera} whole={whole} source={source} />;
  return (
    <Beside>
      <Stage scene={scene} overlays={above} camera={camera} whole={whole} source={source} />
    </Beside>
  );
}
