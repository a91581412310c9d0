// From the numbers of the plane (64 bits) to those of graphics processors (32 bits). Coordinates are taken relative to
// an anchor in the middle of what is drawn, in units of its size; so a million in front of all of them costs nothing.
// What is left of them after rounding is exact enough until something is looked at very closely; `isFine` tells.

import { type Box, type Camera, middleOf } from "./camera";

/** The origin and the unit of numbers of 32 bits. */
export interface Anchor {
  readonly x: number;
  readonly y: number;
  readonly unit: number;
}

/** The anchor of numbers that are small already. */
export const origin: Anchor = { x: 0, y: 0, unit: 1 };

/** How far from its place a pixel may be drawn. */
const ERROR = 2 ** -2;

/** Beyond this, numbers stand for infinitely far: their squares still are numbers of 64 bits. */
const FAR = 1e150;

/** Returns the anchor of a box: its corners are about one unit away. The unit is a power of two: it rounds nothing. */
export function anchorOf(box: Box): Anchor {
  const { x, y, half } = middleOf(box);
  const most = Math.max(half[0], half[1]);
  const power = most > 0 ? Math.ceil(Math.log2(most)) : 0;
  return { x, y, unit: 2 ** Math.max(-1022, Math.min(power, 1023)) };
}

/** Returns a coordinate relative to that of an anchor. */
export function relative(value: number, of: number, unit: number): number {
  const way = value - of;
  const result = Number.isFinite(way) ? way / unit : value / unit - of / unit;
  return Math.max(-FAR, Math.min(result, FAR));
}

/** Returns the camera that sees, of a plane relative to an anchor, what a camera sees of the plane itself. */
export function relativeCamera(camera: Camera, { x, y, unit }: Anchor): Camera {
  return {
    x: relative(camera.x, x, unit),
    y: relative(camera.y, y, unit),
    scale: Math.min(camera.scale * unit, FAR),
  };
}

/**
 * Returns whether numbers of 32 bits are exact enough. Those of the drawing are at most 2 and wrong by 2^-24, those of the
 * camera by as much; `ratio` is how many pixels of the device a CSS pixel has.
 */
export function isFine(camera: Camera, { unit }: Anchor, ratio: number): boolean {
  return unit * camera.scale * ratio * 2 ** -23 <= ERROR;
}

/** Returns coordinates relative to an anchor, in 32 bits. */
export function place(points: Float64Array, { x, y, unit }: Anchor): Float32Array {
  const placed = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 2) {
    placed[i] = relative(points[i], x, unit);
    placed[i + 1] = relative(points[i + 1], y, unit);
  }
  return placed;
}
