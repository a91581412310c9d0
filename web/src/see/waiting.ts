// What waits, on a stack or in a queue, in the order in which it has come; and what goes first.

import { computed } from "@preact/signals";
import { stage } from "../engine/client";
import { pale } from "../stage/palette";
import type { Look, Pen } from "../stage/pen";
import { middleOf, placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { frame, SLOT } from "../state/play";
import { asked } from "./asking";
import { circumcircle } from "./circles";
import { Labels, strength } from "./looks";
import { looksAt, standing } from "./turn";
import { type Waiter, waitersOf } from "./waiters";

const arrivals = asked(
  stage,
  () =>
    looksAt("waiting") && frame.value && Object.keys(frame.value.waiting).length > 0 ? standing.value : null,
  (engine, { position }) => engine.looks.arrivals(SLOT, position),
);

/** All that waits in the scene that is shown. */
export const waiters = computed(() => {
  if (!looksAt("waiting") || !frame.value) return [];
  const known = arrivals.value;
  return waitersOf(frame.value.waiting, known?.ranks ?? {}, known?.next ?? null);
});

/** Draws what waits. */
export const waiting: Overlay = (pen) => {
  const shown = frame.value;
  const all = waiters.value;
  if (!shown || all.length === 0) return;
  // A carpet of them is paler, so that the scene is seen below it.
  const much = strength(pen, all.length, 120);
  const edges = all.filter((waiter) => isPlain(waiter)).flatMap(({ vertices }) => vertices);
  pen.edges(shown.points, edges, edgeLook(pen, false, much));
  for (const waiter of all) if (!isPlain(waiter)) outline(pen, shown.points, waiter, much);
  const labels = new Labels();
  for (const { rank, isNext, vertices } of all.toSorted((a, b) => Number(b.isNext) - Number(a.isNext))) {
    const [x, y] = pen.at(...middleOf(shown.points, vertices));
    const aside = vertices.length === 1 ? 14 : 0;
    if (rank > 0) labels.chip(pen, x, y - aside, String(rank), isNext ? pen.palette.ink : pen.palette.asked);
  }
};

/** An edge like all the others: of these there may be many thousands. */
const isPlain = ({ vertices, isNext }: Waiter): boolean => vertices.length === 2 && !isNext;

const edgeLook = ({ palette }: Pen, isNext: boolean, much: number): Look => ({
  stroke: pale(palette.asked, strengthOf(isNext, much)),
  width: isNext ? 6 : 3.5 + 2.5 * much,
});

const strengthOf = (isNext: boolean, much: number): number => (isNext ? 0.85 : 0.25 + 0.2 * much);

function outline(pen: Pen, points: Float64Array, { queue, vertices, isNext }: Waiter, much: number): void {
  const colour = pen.palette.asked;
  const share = strengthOf(isNext, much);
  if (vertices.length === 1) {
    pen.dot(...placeOf(points, vertices[0]), { stroke: pale(colour, share), width: 3, size: 7 });
  } else if (vertices.length === 2) {
    pen.polygon(points, vertices, edgeLook(pen, isNext, much));
  } else if (queue === "events") {
    // Three arcs that meet when the sweep has come to the end of their circle.
    const round = circumcircle(points, vertices);
    if (round)
      pen.circle(round.x, round.y, round.radius, {
        stroke: pale(colour, share * 0.8),
        width: isNext ? 2 : 1,
        dash: [3, 4],
      });
  } else {
    pen.polygon(points, vertices, {
      fill: pale(colour, share * 0.45),
      stroke: pale(colour, share),
      width: 1.5,
    });
  }
}
