// Lines of the plane, however long, cut to the view and drawn.

import type { Pen } from "../stage/pen";
import { clip, type Dual } from "./dual";
import { pale, strength } from "./looks";

/** Lines that are stroked at once; of very many canvases make a slow path. */
const BATCH = 2_000;

/** Cuts the lines to the view, in full precision: pixels far outside are more than canvases can count. */
export function linesIn(pen: Pen, { segments, rays }: Dual): [number, number, number, number][] {
  const { low, high } = pen.seen;
  const found: [number, number, number, number][] = [];
  const add = (line: [number, number, number, number]) => {
    const part = clip(line, low, high);
    if (!part) return;
    const [x0, y0, x1, y1] = line;
    const at = (share: number) => pen.at(x0 + share * (x1 - x0), y0 + share * (y1 - y0));
    found.push([...at(part[0]), ...at(part[1])]);
  };
  for (let i = 0; i < segments.length; i += 4) {
    add([segments[i], segments[i + 1], segments[i + 2], segments[i + 3]]);
  }
  const across = Math.hypot(high[0] - low[0], high[1] - low[1]);
  for (let i = 0; i < rays.length; i += 4) {
    const [x, y, dx, dy] = rays.subarray(i, i + 4);
    // As far as the other end of the view, wherever it begins.
    const length = across + Math.hypot(x - pen.camera.x, y - pen.camera.y);
    add([x, y, x + length * dx, y + length * dy]);
  }
  return found;
}

/** Draws lines, paler where there are too many. */
export function drawLines(pen: Pen, lines: [number, number, number, number][], colour: string): void {
  const { context } = pen;
  const share = 0.2 + 0.75 * strength(pen, lines.length, 14);
  context.strokeStyle = pale(colour, share);
  context.lineWidth = share > 0.5 ? 1.75 : 1;
  context.setLineDash([]);
  for (let i = 0; i < lines.length; i += BATCH) {
    context.beginPath();
    for (const [x0, y0, x1, y1] of lines.slice(i, i + BATCH)) {
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
    }
    context.stroke();
  }
}
