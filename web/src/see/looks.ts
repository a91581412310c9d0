// What overlays share: what fades when there is too much of it, chips of text.

import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";

/** Tells whether a place is seen, or lies just outside. */
export function isNear(pen: Pen, x: number, y: number, margin = 20): boolean {
  const [px, py] = pen.at(x, y);
  const { width, height } = pen.size;
  return px > -margin && py > -margin && px < width + margin && py < height + margin;
}

/** Returns how strongly things are drawn of which so many are seen: all of it if each has `room` pixels around it, none with half of that. */
export function strength({ size }: Pen, seen: number, room: number): number {
  const each = Math.sqrt((size.width * size.height) / Math.max(seen, 1));
  return Math.max(0, Math.min(1, (2 * each) / room - 1));
}

/** Writes a text on a chip, centered at a pixel, and keeps it in view. */
export function chip(
  { context, palette, size }: Pen,
  px: number,
  py: number,
  text: string,
  colour: string,
  strong = false,
): void {
  context.font = `${strong ? "600 " : ""}${strong ? 13 : 11}px system-ui, sans-serif`;
  const half = context.measureText(text).width / 2 + 5;
  const tall = strong ? 11 : 8;
  const x = Math.max(half + 4, Math.min(size.width - half - 4, px));
  const y = Math.max(tall + 4, Math.min(size.height - tall - 4, py));
  context.beginPath();
  context.roundRect(x - half, y - tall, 2 * half, 2 * tall, tall);
  context.fillStyle = pale(palette.paper, 0.9);
  context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.setLineDash([]);
  context.stroke();
  context.fillStyle = colour;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, x, y + 0.5);
  context.textAlign = "start";
  context.textBaseline = "alphabetic";
}

/** Chips that do not lie upon each other: who comes first has the place. */
export class Labels {
  private readonly taken: [x: number, y: number, half: number][] = [];

  /** Writes a text on a chip if there is room for it. */
  chip(pen: Pen, px: number, py: number, text: string, colour: string): void {
    const half = 4 * text.length + 6;
    const isFree = ([x, y, other]: [number, number, number]) =>
      Math.abs(px - x) >= half + other || Math.abs(py - y) >= 18;
    if (!this.taken.every(isFree) || this.taken.length >= MOST_LABELS) return;
    this.taken.push([px, py, half]);
    chip(pen, px, py, text, colour);
  }
}

/** More of them nobody reads. */
const MOST_LABELS = 250;
