// Which part of the plane is seen. The plane's y points up, the screen's down. Coordinates may be as large and as small
// as numbers go: differences that overflow are taken by halves, and what lies beyond the numbers stays at their end.

import type { Coordinates } from "../engine/protocol";

/** The place in the middle of the view, and how many CSS pixels a unit of the plane takes. */
export interface Camera {
  readonly x: number;
  readonly y: number;
  readonly scale: number;
}

/** The size of the view in CSS pixels. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Box {
  readonly low: readonly [number, number];
  readonly high: readonly [number, number];
}

/** Part of the view that is left free around what is fitted into it. */
const MARGIN = 0.06;

/** The scales whose inverses are numbers, too. */
const LEAST = 2 ** -1020;
const MOST = 2 ** 1020;

/** How many pixels neighbouring numbers may be apart; beyond, the view would move by leaps. */
const LEAP = 16;

const boxes = new WeakMap<Coordinates, Box>();

/** Returns the smallest box around points; a unit square if there are none. Linear, once for each array. */
export function boxOf(points: Coordinates): Box {
  const box = boxes.get(points) ?? measure(points);
  boxes.set(points, box);
  return box;
}

function measure(points: Coordinates): Box {
  if (points.length === 0) return { low: [0, 0], high: [1, 1] };
  let [left, right, bottom, top] = [points[0], points[0], points[1], points[1]];
  for (let i = 2; i < points.length; i += 2) {
    const x = points[i];
    const y = points[i + 1];
    if (x < left) left = x;
    else if (x > right) right = x;
    if (y < bottom) bottom = y;
    else if (y > top) top = y;
  }
  return { low: [left, bottom], high: [right, top] };
}

/** Returns the middle of a box, and half of its width and height. */
export function middleOf({ low, high }: Box): { x: number; y: number; half: [number, number] } {
  const half: [number, number] = [high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2];
  return { x: low[0] + half[0], y: low[1] + half[1], half };
}

/** Returns the camera that sees all of a box. Of a single place it sees as much as lies around the origin. */
export function fit(box: Box, { width, height }: Size): Camera {
  const { x, y, half } = middleOf(box);
  const room = (1 - 2 * MARGIN) / 2;
  const least = half[0] > 0 || half[1] > 0 ? 0 : Math.max(Math.abs(x), Math.abs(y)) || 1;
  const scale = Math.min(
    (room * Math.max(width, 1)) / Math.max(half[0], least),
    (room * Math.max(height, 1)) / Math.max(half[1], least),
  );
  return { x, y, scale: Math.max(LEAST, Math.min(scale, MOST)) };
}

/** Returns the place in the plane of a pixel. */
export function toPlane(camera: Camera, { width, height }: Size, px: number, py: number): [number, number] {
  return [
    bounded(camera.x + (px - width / 2) / camera.scale),
    bounded(camera.y - (py - height / 2) / camera.scale),
  ];
}

/** Returns the pixel of a place in the plane. */
export function toScreen(camera: Camera, { width, height }: Size, x: number, y: number): [number, number] {
  return [width / 2 + pixels(x, camera.x, camera.scale), height / 2 - pixels(y, camera.y, camera.scale)];
}

/** Moves the view by pixels. */
export function pan(camera: Camera, dx: number, dy: number): Camera {
  return {
    ...camera,
    x: bounded(camera.x - dx / camera.scale),
    y: bounded(camera.y + dy / camera.scale),
  };
}

/** Returns the camera of the same scale that sees a place of the plane at a pixel. */
export function hold(
  { scale }: Camera,
  { width, height }: Size,
  [x, y]: readonly [number, number],
  px: number,
  py: number,
): Camera {
  return { x: bounded(x - (px - width / 2) / scale), y: bounded(y + (py - height / 2) / scale), scale };
}

/** Zooms by a factor; the place under the pixel stays there. */
export function zoom(
  camera: Camera,
  { width, height }: Size,
  factor: number,
  px: number,
  py: number,
): Camera {
  const scale = zoomed(camera, factor);
  const [dx, dy] = [px - width / 2, py - height / 2];
  return {
    x: bounded(camera.x + (bounded(dx / camera.scale) - bounded(dx / scale))),
    y: bounded(camera.y - (bounded(dy / camera.scale) - bounded(dy / scale))),
    scale,
  };
}

/** Returns the scale times a factor, or as near to it as the numbers around the camera allow. */
function zoomed({ x, y, scale }: Camera, factor: number): number {
  if (factor < 1) return Math.max(LEAST, scale * factor);
  const gap = Math.max(Math.abs(x), Math.abs(y)) * 2 ** -52;
  return Math.max(scale, Math.min(scale * factor, LEAP / gap, MOST));
}

function pixels(to: number, from: number, scale: number): number {
  const way = to - from;
  return bounded(Number.isFinite(way) ? way * scale : (to / 2 - from / 2) * scale * 2);
}

const bounded = (value: number): number => Math.max(-Number.MAX_VALUE, Math.min(value, Number.MAX_VALUE));
