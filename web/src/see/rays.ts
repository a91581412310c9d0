// Who sees whom: the rays of this turn.

import { pale } from "../stage/palette";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { frame } from "../state/play";
import { fillHead, headOf } from "./arrows";
import { turn } from "./turn";

/** Draws the rays: whole where nothing is in the way, broken where something is. */
export const rays: Overlay = (pen) => {
  const points = frame.value?.points;
  if (!points) return;
  const cast = turn.value.filter(({ kind }) => kind === "ray-cast");
  for (const [i, { event }] of cast.entries()) {
    const [from, to] = (event.ray as [number, number]).map((v) => placeOf(points, v));
    const isVisible = event.is_visible === true;
    const colour = pale(isVisible ? pen.palette.good : pen.palette.bad, i + 1 === cast.length ? 1 : 0.55);
    pen.path([from, to], { stroke: colour, width: 1.75, dash: isVisible ? [] : [4, 5] });
    fillHead(pen.context, headOf(pen.at(...from), pen.at(...to), 10), colour);
  }
};
