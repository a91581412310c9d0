// The Voronoi cells of the points, and the dual of the triangulation: where it is Delaunay, they are the same.

import { computed } from "@preact/signals";
import { mesher, stage } from "../engine/client";
import type { Coordinates, Indices } from "../engine/protocol";
import type { Overlay } from "../stage/Stage";
import { mode } from "../state/mode";
import { frame, SLOT } from "../state/play";
import { asked } from "./asking";
import { type Dual, dualOf } from "./dual";
import { drawLines, linesIn } from "./dualLines";
import { linksOf, type Shown, shown } from "./shown";
import { looksAt, looksAtMesh, standing } from "./turn";

/** Triangles, or points, beyond which nothing is drawn: it would take longer than anyone wants to wait for. */
const MOST = 1_500_000;

const none = new Float64Array();

let before: Coordinates = none;

/** The points of the run, in an array that stays the same as long as they do: most steps move none. */
const points = computed<Coordinates>(() => {
  const now = frame.value?.points ?? none;
  if (now.length !== before.length || !now.every((value, i) => value === before[i])) before = now;
  return before;
});

const inRun = asked(
  stage,
  () => {
    if (!looksAt("voronoi") || !standing.value || points.value.length > 2 * MOST) return null;
    return { of: standing.value.of, points: points.value };
  },
  // The position is of no matter to the cells, so that it is not part of what is wanted.
  (engine) => engine.looks.cells(SLOT, standing.peek()?.position ?? 0),
);

const inMesh = asked(
  mesher,
  () => {
    if (!looksAtMesh("voronoi") || !shown.value || shown.value.points.length > 2 * MOST) return null;
    return { of: shown.value.of };
  },
  (engine) => engine.meshes.cells(),
);

const cells = computed(() => (mode.value === "mesh" ? inMesh.value : inRun.value));

/** Draws the cells of all points, whatever triangles there are. */
export const voronoi: Overlay = (pen) => {
  if (!cells.value) return;
  drawLines(pen, linesIn(pen, { segments: cells.value, rays: none }), pen.palette.sweep);
};

const known = new WeakMap<Indices, Dual>();

/** Draws the dual of the triangulation. */
export const dual: Overlay = (pen) => {
  const scene = shown.value;
  if (!scene || scene.triangles.length > 3 * MOST) return;
  const found = known.get(scene.triangles) ?? dualOfScene(scene);
  known.set(scene.triangles, found);
  drawLines(pen, linesIn(pen, found), pen.palette.front);
};

function dualOfScene(scene: Shown): Dual {
  const links = linksOf(scene);
  const walls = new Set<number>();
  const { constrained } = scene;
  for (let e = 0; e < constrained.length; e += 2) {
    walls.add(links.find(constrained[e], constrained[e + 1]));
    walls.add(links.find(constrained[e + 1], constrained[e]));
  }
  return dualOf(scene.points, links, (h) => walls.has(h));
}
