// Lines of the plane, however long, cut to the view and drawn.

import { clipLine } from "../stage/clip";
import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";
import type { Dual } from "./dual";
import { strength } from "./looks";

/** Lines that are stroked at once; of very many canvases make a slow path. */
const BATCH = 2_000;

/** More lines than this in the view are a carpet that takes seconds to draw: none of them is. */
const CARPET = 60_000;

type Line = [x0: number, y0: number, x1: number, y1: number];

/**
 * Cuts the lines to the view, in full precision: pixels far outside are more than canvases can count. None if they
 * would be a carpet.
 */
export function linesIn(pen: Pen, { segments, rays }: Dual): Line[] {
  const { low, high } = pen.seen;
  const found: Line[] = [];
  const add = (x0: number, y0: number, x1: number, y1: number) => {
    // Most are far off to one side, which is quickly seen.
    if ((x0 < low[0] && x1 < low[0]) || (x0 > high[0] && x1 > high[0])) return;
    if ((y0 < low[1] && y1 < low[1]) || (y0 > high[1] && y1 > high[1])) return;
    const part = clipLine([x0, y0], [x1, y1], { low, high });
    if (part) found.push([...pen.at(...part[0]), ...pen.at(...part[1])]);
  };
  for (let i = 0; i < segments.length; i += 4) {
    if (found.length > CARPET) return [];
    add(segments[i], segments[i + 1], segments[i + 2], segments[i + 3]);
  }
  const across = Math.hypot(high[0] - low[0], high[1] - low[1]);
  for (let i = 0; i < rays.length; i += 4) {
    const [x, y, dx, dy] = rays.subarray(i, i + 4);
    // As far as the other end of the view, wherever it begins.
    const length = across + Math.hypot(x - pen.camera.x, y - pen.camera.y);
    add(x, y, x + length * dx, y + length * dy);
  }
  return found;
}

/** Room in pixels for a line, to be drawn in full. */
const ROOM = 14;

/** Draws lines, paler where there are too many. */
export function drawLines(pen: Pen, lines: Line[], colour: string): void {
  const { context } = pen;
  const share = 0.2 + 0.75 * strength(pen, lines.length, ROOM);
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
