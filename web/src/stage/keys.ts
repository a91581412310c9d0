// Keys that move the view while the stage has the focus.

import { bind } from "../app/shortcuts";
import { pan } from "./camera";
import type { View } from "./view";

/** Parts of the view by which an arrow moves it; with Shift the larger one. */
const STEP = 1 / 10;
const LEAP = 1 / 2;

/** What a key of zooming zooms by. */
export const ZOOM = 1.5;

const arrows: Record<string, readonly [number, number]> = {
  ArrowLeft: [1, 0],
  ArrowRight: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const others: Record<string, (view: View) => void> = {
  "+": (view) => view.zoomBy(ZOOM),
  "=": (view) => view.zoomBy(ZOOM),
  "-": (view) => view.zoomBy(1 / ZOOM),
  _: (view) => view.zoomBy(1 / ZOOM),
  "0": (view) => view.glide(null),
};

for (const arrow of Object.keys(arrows)) bind("stage", arrow, "pan");
for (const arrow of Object.keys(arrows)) bind("stage", `Shift+${arrow}`, "panFar");
bind("stage", "+", "zoomIn");
bind("stage", "-", "zoomOut");
bind("stage", "0", "fit");

/** Does what a key says; the rest of the page does not hear of it then. */
export function press(event: KeyboardEvent, view: View): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const arrow = arrows[event.key];
  const other = others[event.key];
  if (!arrow && !other) return;
  event.preventDefault();
  event.stopPropagation();
  if (arrow) moveBy(view, arrow, event.shiftKey ? LEAP : STEP);
  else other(view);
}

function moveBy(view: View, [x, y]: readonly [number, number], part: number): void {
  const { width, height } = view.size.peek();
  const way = part * Math.min(width, height);
  view.glide(pan(view.goal, x * way, y * way));
}
