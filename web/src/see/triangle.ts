// The triangle under the pointer, its circumcircle, and who lies in there.

import { computed } from "@preact/signals";
import { stage } from "../engine/client";
import { pale } from "../stage/palette";
import { pickerOf } from "../stage/picking";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { pointer } from "../stage/tool";
import { SLOT } from "../state/play";
import { switched } from "../state/see";
import { words } from "../words";
import { asked } from "./asking";
import { circumcircle } from "./circles";
import { chip } from "./looks";
import { shown } from "./shown";
import { looksAt, standing } from "./turn";
import { type Inhabitants, inhabitants, settle } from "./verdicts";

/** Vertices near a circle that are asked about: there are few, but for points on a circle. */
const MOST = 200;

/** The triangle under the pointer, by its number; null: none. */
const under = computed(() => {
  const [scene, at] = [shown.value, pointer.value];
  if (!scene || !at || !switched.value.has("triangle")) return null;
  return pickerOf(scene).triangle(at.x, at.y);
});

/** The triangle, and who lies in its circle as far as rounded numbers tell. */
const guessed = computed(() => {
  if (!shown.value || under.value === null) return null;
  const { points, triangles } = shown.value;
  const corners = triangles.slice(3 * under.value, 3 * under.value + 3);
  return { corners, ...inhabitants(points, corners) };
});

/** What the module says, exactly, of those of whom rounded numbers do not tell. */
const exact = asked(
  stage,
  () => {
    if (!looksAt("triangle") || !guessed.value?.on.length || !standing.value) return null;
    return { ...standing.value, guess: guessed.value };
  },
  async (engine, { position, guess }) => {
    const near = guess.on.slice(0, MOST);
    return { guess, sides: await engine.looks.sides(SLOT, position, [...guess.corners], near) };
  },
);

/** Who lies in the circle, and on it, as well as anyone knows by now. */
const known = computed<(Inhabitants & { corners: Uint32Array }) | null>(() => {
  const [guess, said] = [guessed.value, exact.value];
  if (!guess || said?.guess !== guess) return guess;
  return { corners: guess.corners, ...settle(guess, said.sides) };
});

/** Draws the triangle and its circle. */
export const triangle: Overlay = (pen) => {
  const [scene, at, now] = [shown.value, pointer.value, known.value];
  if (!scene || !at || !now) return;
  const { points } = scene;
  const { corners, inside, on } = now;
  const { good, bad, paper } = pen.palette;
  const colour = inside.length > 0 ? bad : good;
  const round = circumcircle(points, corners);
  pen.polygon(points, corners, { fill: pale(colour, 0.18), stroke: colour, width: 2 });
  if (round) {
    pen.circle(round.x, round.y, round.radius, { stroke: colour, width: 1.75, fill: pale(colour, 0.06) });
    pen.dot(round.x, round.y, { fill: colour, size: 3 });
  }
  for (const v of inside.slice(0, 500))
    pen.dot(...placeOf(points, v), { fill: bad, stroke: paper, width: 1.5, size: 5.5 });
  for (const v of on.slice(0, 500))
    pen.dot(...placeOf(points, v), { stroke: pen.palette.asked, width: 2.5, size: 6 });
  const [px, py] = pen.at(at.x, at.y);
  chip(pen, px, py - 30, words.value.see.circleHolds(inside.length, on.length), colour, true);
};
