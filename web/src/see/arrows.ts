// Arrows along edges and between places, in pixels: y points down here.

import type { Pen } from "../stage/pen";

export type Pixel = readonly [x: number, y: number];

/** A curve from `start` to `end`, bent towards `control`, with a head, and where its name stands. */
export interface Arrow {
  start: Pixel;
  control: Pixel;
  end: Pixel;
  head: readonly [Pixel, Pixel, Pixel];
  label: Pixel;
}

/** Lengths in pixels. */
const HEAD = 9;
const APART = 7;
const BEND = 9;
const NAME = 17;

/**
 * Lays the arrow of a half-edge along its edge: on the left of who goes from `from` to `to`, away from both ends,
 * and bent a little; its name stands at a share of the way. Null if the edge is too short for it.
 */
export function besideEdge(from: Pixel, to: Pixel, share = 0.5): Arrow | null {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (!(length > 2.5 * HEAD)) return null;
  const [ux, uy] = [dx / length, dy / length];
  // Left, where y points down.
  const [lx, ly] = [uy, -ux];
  const inset = Math.min(18, length / 5);
  const at = (along: number, aside: number): Pixel => [
    from[0] + ux * along + lx * aside,
    from[1] + uy * along + ly * aside,
  ];
  const bend = Math.min(BEND, length / 8);
  const [start, end] = [at(inset, APART), at(length - inset, APART)];
  const control = at(length / 2, APART + 2 * bend);
  return { start, control, end, head: headOf(control, end), label: at(length * share, APART + bend + NAME) };
}

/** Returns the head of an arrow that comes from one place and ends at another: its tip first. */
export function headOf(from: Pixel, tip: Pixel, size = HEAD): [Pixel, Pixel, Pixel] {
  const [dx, dy] = [tip[0] - from[0], tip[1] - from[1]];
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [(dx / length) * size, (dy / length) * size];
  const [x, y] = [tip[0] - ux, tip[1] - uy];
  return [tip, [x - uy * 0.45, y + ux * 0.45], [x + uy * 0.45, y - ux * 0.45]];
}

/** Draws an arrow. */
export function drawArrow(
  { context }: Pen,
  { start, control, end, head }: Arrow,
  colour: string,
  width = 2,
): void {
  context.setLineDash([]);
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.beginPath();
  context.moveTo(...start);
  context.quadraticCurveTo(...control, ...end);
  context.stroke();
  fillHead(context, head, colour);
}

/** Draws the head of an arrow. */
export function fillHead(context: CanvasRenderingContext2D, head: readonly Pixel[], colour: string): void {
  context.beginPath();
  for (const corner of head) context.lineTo(...corner);
  context.closePath();
  context.fillStyle = colour;
  context.fill();
}
