// Segments to which a vertex is too close, and the circles that say so.

import { pale } from "../stage/palette";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";
import { diametral } from "./circles";
import { encroachments } from "./encroachments";
import { isNear, strength } from "./looks";
import { linksOf, shown } from "./shown";
import { turn } from "./turn";
import { crowding } from "./verdicts";

/** Draws the segments that a vertex is too close to, or would have been, in this turn. */
export const encroached: Overlay = (pen) => {
  const points = frame.value?.points;
  if (!points) return;
  const { bad: colour, paper } = pen.palette;
  for (const { segment, by } of encroachments(turn.value)) {
    const { x, y, radius } = diametral(points, segment);
    pen.circle(x, y, radius, { stroke: colour, width: 2, fill: pale(colour, 0.1) });
    pen.polygon(points, segment, { stroke: colour, width: 4 });
    if (typeof by === "number")
      pen.dot(...placeOf(points, by), { fill: colour, stroke: paper, width: 2, size: 6 });
    else pen.dot(...by, { fill: paper, stroke: colour, width: 2.5, size: 5 });
  }
};

/** Draws the diametral circles of all constraints. */
export const circles: Overlay = (pen) => {
  const scene = shown.value;
  if (!scene || scene.constrained.length === 0) return;
  const { points, constrained } = scene;
  const state = crowding(points, constrained, linksOf(scene));
  const near = Array.from(state.keys()).filter((e) =>
    isNear(pen, ...placeOf(points, constrained[2 * e]), 400),
  );
  const share = 0.15 + 0.55 * strength(pen, near.length, 40);
  for (const e of near) {
    const isBad = state[e] === 1;
    const colour = isBad ? pen.palette.bad : pen.palette.locked;
    const look = { stroke: pale(colour, isBad ? Math.max(share, 0.6) : share), width: isBad ? 1.75 : 1 };
    const { x, y, radius } = diametral(points, constrained.subarray(2 * e, 2 * e + 2));
    pen.circle(x, y, radius, look);
  }
};
