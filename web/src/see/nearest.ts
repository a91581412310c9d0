// The vertex nearest to the pointer, and the walk through the triangles by which it is found.

import { computed } from "@preact/signals";
import { mesher, stage } from "../engine/client";
import { pale } from "../stage/palette";
import { middleOf, placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { pointer } from "../stage/tool";
import { mode } from "../state/mode";
import { SLOT } from "../state/play";
import { asked } from "./asking";
import { chip } from "./looks";
import { shown } from "./shown";
import { looksAt, looksAtMesh, standing } from "./turn";

const inRun = asked(
  stage,
  () => {
    if (!looksAt("nearest") || !pointer.value || !standing.value) return null;
    return { ...standing.value, x: pointer.value.x, y: pointer.value.y };
  },
  (engine, { position, x, y }) => engine.looks.nearest(SLOT, position, x, y),
);

const inMesh = asked(
  mesher,
  () => {
    if (!looksAtMesh("nearest") || !pointer.value || !shown.value) return null;
    return { of: shown.value.of, x: pointer.value.x, y: pointer.value.y };
  },
  (engine, { x, y }) => engine.meshes.nearest(x, y),
);

const found = computed(() => (mode.value === "mesh" ? inMesh.value : inRun.value));

/** Draws the walk, and a line to the vertex. */
export const nearest: Overlay = (pen) => {
  const [scene, at, now] = [shown.value, pointer.value, found.value];
  if (!scene || !at || !now) return;
  const { points, triangles } = scene;
  const colour = pen.palette.sweep;
  // The scene may have gone on since, and have fewer of them.
  const walk = now.walk.map((t) => triangles.subarray(3 * t, 3 * t + 3)).filter(({ length }) => length === 3);
  for (const corners of walk) pen.polygon(points, corners, { fill: pale(colour, 0.2) });
  const middles = walk.map((corners) => middleOf(points, corners));
  pen.path(middles, { stroke: pale(colour, 0.8), width: 2 });
  if (2 * now.vertex >= points.length) return;
  const place = placeOf(points, now.vertex);
  pen.path([[at.x, at.y], place], { stroke: colour, width: 2, dash: [4, 4] });
  pen.dot(...place, { fill: colour, stroke: pen.palette.paper, width: 2, size: 7 });
  const [px, py] = pen.at(...place);
  chip(pen, px, py - 20, String(now.vertex), colour, true);
};
