// Guessing on the stage: a click on an edge. Everywhere else the view is moved, as ever.

import { computed, effect } from "@preact/signals";
import { type Place, pointer, type Tool, tool } from "../stage/tool";
import { mode } from "../state/mode";
import { cursor, guess, guessable, puzzle } from "../state/predict";
import { nearestEdge, type Quad } from "./edges";

/** How near a pointer must come, in pixels: fingers are broad. */
const NEAR = { mouse: 14, touch: 26 };

function under(x: number, y: number, reach: number): Quad | null {
  const of = puzzle.peek();
  return of && nearestEdge(of.points, guessable.peek(), x, y, reach);
}

const at = ({ x, y, pixel, event }: Place) =>
  under(x, y, pixel * (event.pointerType === "touch" ? NEAR.touch : NEAR.mouse));

let pressed: Quad | null = null;

const guessing: Tool = {
  cursor: "pointer",
  down(place) {
    pressed = at(place);
    return pressed !== null;
  },
  up(place) {
    const quad = at(place);
    if (quad && quad === pressed) void guess(quad);
    pressed = null;
  },
  cancel() {
    pressed = null;
  },
};

/** The edge under the pointer, or else the one that the keyboard has chosen. */
export const hovered = computed<Quad | null>(() => {
  void guessable.value;
  const place = pointer.value;
  const seen = place && under(place.x, place.y, place.pixel * NEAR.mouse);
  return seen ?? guessable.value[cursor.value] ?? null;
});

effect(() => {
  if (mode.value === "predict" && guessable.value.length > 0) tool.value = guessing;
  else if (tool.peek() === guessing) tool.value = null;
});
