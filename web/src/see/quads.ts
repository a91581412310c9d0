// Edges that the circle test has something to say of: illegal ones, and those where it says neither yes nor no.

import { computed } from "@preact/signals";
import { stage } from "../engine/client";
import type { Indices } from "../engine/protocol";
import { pale } from "../stage/palette";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { mode } from "../state/mode";
import { SLOT } from "../state/play";
import { isLifted } from "../state/see";
import { asked } from "./asking";
import { circumcircle } from "./circles";
import { isNear, strength } from "./looks";
import { linksOf, type Shown, shown } from "./shown";
import { looksAt, standing } from "./turn";
import { surelyIllegal } from "./verdicts";

const judged = asked(
  stage,
  () =>
    looksAt("illegal", "cocircular") || (isLifted.value && mode.value === "play") ? standing.value : null,
  (engine, { position }) => engine.looks.edges(SLOT, position),
);

/** Edges that are not locally Delaunay nor constraints: ends and opposite corners, four numbers each. Exact in a run; in a mesh those that are so for certain. Null: nobody knows. */
export const illegalEdges = computed<ArrayLike<number> | null>(() => {
  const scene = shown.value;
  if (!scene) return null;
  return mode.value === "mesh" ? certain(scene) : (judged.value?.illegal ?? null);
});

const known = new WeakMap<Indices, number[]>();

function certain(scene: Shown): number[] {
  const found = known.get(scene.triangles) ?? surelyIllegal(scene.points, scene.constrained, linksOf(scene));
  known.set(scene.triangles, found);
  return found;
}

/** Draws the edges that are not locally Delaunay. */
export const illegal: Overlay = (pen) => {
  const points = shown.value?.points;
  if (!points) return;
  const rows = illegalEdges.value ?? [];
  for (let i = 0; i < rows.length; i += 4) {
    const edge = [rows[i], rows[i + 1]];
    pen.polygon(points, edge, { stroke: pale(pen.palette.bad, 0.28), width: 8 });
    pen.polygon(points, edge, { stroke: pen.palette.bad, width: 2, dash: [7, 5] });
  }
};

/** Draws quadrilaterals with all corners on one circle, and the circles while these are few. */
export const cocircular: Overlay = (pen) => {
  const points = shown.value?.points;
  const rows = judged.value?.cocircular;
  if (!points || !rows) return;
  const colour = pen.palette.sweep;
  const near: Uint32Array[] = [];
  for (let i = 0; i < rows.length; i += 4) {
    if (isNear(pen, ...placeOf(points, rows[i]), 200)) near.push(rows.subarray(i, i + 4));
  }
  const share = strength(pen, near.length, 50);
  for (const [a, b, c, d] of near) {
    pen.polygon(points, [a, d, b, c], { fill: pale(colour, 0.13) });
    pen.polygon(points, [c, d], { stroke: pale(colour, 0.8), width: 1.25, dash: [2, 4] });
    const round = share > 0 && circumcircle(points, [a, b, c]);
    if (round) pen.circle(round.x, round.y, round.radius, { stroke: pale(colour, 0.5 * share), width: 1 });
  }
};
