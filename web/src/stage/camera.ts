// Which part of the plane is seen. The plane's y points up, the screen's down.

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

/** Returns the smallest box around points; a unit square if there are none. Linear. */
export function boxOf(points: Coordinates): Box {
  const [low, high]: [[number, number], [number, number]] = [
    [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY],
    [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY],
  ];
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = [points[i], points[i + 1]];
    if (x < low[0]) low[0] = x;
    if (x > high[0]) high[0] = x;
    if (y < low[1]) low[1] = y;
    if (y > high[1]) high[1] = y;
  }
  return points.length > 0 ? { low, high } : { low: [0, 0], high: [1, 1] };
}

/** Returns the camera that sees all of a box. */
export function fit({ low, high }: Box, { width, height }: Size): Camera {
  const room = 1 - 2 * MARGIN;
  // Halves first: a box may be as wide as numbers go.
  const half = [high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2];
  const scale = Math.min((room * width) / half[0], (room * height) / half[1]) / 2;
  return {
    x: low[0] + half[0],
    y: low[1] + half[1],
    scale: Number.isFinite(scale) && scale > 0 ? scale : 1,
  };
}

/** Returns the place in the plane of a pixel. */
export function toPlane(camera: Camera, { width, height }: Size, px: number, py: number): [number, number] {
  return [camera.x + (px - width / 2) / camera.scale, camera.y - (py - height / 2) / camera.scale];
}

/** Returns the pixel of a place in the plane. */
export function toScreen(camera: Camera, { width, height }: Size, x: number, y: number): [number, number] {
  return [width / 2 + (x - camera.x) * camera.scale, height / 2 - (y - camera.y) * camera.scale];
}

/** Moves the view by pixels. */
export function pan(camera: Camera, dx: number, dy: number): Camera {
  return { ...camera, x: camera.x - dx / camera.scale, y: camera.y + dy / camera.scale };
}

/** Zooms by a factor; the place under the pixel stays there. */
export function zoom(camera: Camera, size: Size, factor: number, px: number, py: number): Camera {
  const [x, y] = toPlane(camera, size, px, py);
  const scale = camera.scale * factor;
  // Beyond this pixels or places run out of numbers.
  if (!Number.isFinite(scale) || scale < 1e-300) return camera;
  return { x: x + (camera.x - x) / factor, y: y + (camera.y - y) / factor, scale };
}
