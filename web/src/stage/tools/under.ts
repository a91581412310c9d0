// What of the drawing is under the pointer, and how near is near.

import { computed } from "@preact/signals";
import { drawing } from "../../state/drawing";
import { pointer } from "../tool";
import { nearestPoint, nearestSegment } from "./near";

/** How near, in pixels, a pointer must come; fingers are wider than mice. */
const MOUSE = 9;
const FINGER = 22;

/** Where something is looked for. */
export interface Spot {
  x: number;
  y: number;
  pixel: number;
  event?: PointerEvent;
}

export type Under =
  | { kind: "point"; point: number }
  | { kind: "hole"; hole: number }
  | { kind: "segment"; segment: number };

/** Returns how far from a place in the plane things are still near. */
export const reach = ({ pixel, event }: Spot): number =>
  pixel * (event?.pointerType === "touch" ? FINGER : MOUSE);

/** Returns the point of the drawing that is near; null if there is none. */
export function pointNear(spot: Spot): number | null {
  return drawing.value ? nearestPoint(drawing.value.points, spot.x, spot.y, reach(spot)) : null;
}

/** Returns the place of a hole that is near; null if there is none. */
export function holeNear(spot: Spot): number | null {
  return drawing.value ? nearestPoint(drawing.value.holes, spot.x, spot.y, reach(spot)) : null;
}

/** Returns the segment that is near; null if there is none. */
export function segmentNear(spot: Spot): number | null {
  if (!drawing.value) return null;
  const { points, segments } = drawing.value;
  return nearestSegment(points, segments, spot.x, spot.y, reach(spot));
}

/** Returns what is near: points before holes before segments. */
export function under(spot: Spot): Under | null {
  const point = pointNear(spot);
  if (point !== null) return { kind: "point", point };
  const hole = holeNear(spot);
  if (hole !== null) return { kind: "hole", hole };
  const segment = segmentNear(spot);
  return segment === null ? null : { kind: "segment", segment };
}

/** What is under the pointer while it hovers. */
export const hovered = computed<Under | null>(() => (pointer.value ? under(pointer.value) : null));
