// Draws the timeline: insertions above flips, ends of stages across both, breakpoints at the top.

import type { MomentKind } from "./moments";
import { bars, pixelOf } from "./strip";

export interface Strip {
  length: number;
  position: number;
  moments: Partial<Record<MomentKind, Uint32Array>>;
  ticks: number[];
  colours: Record<MomentKind | "breakpoint" | "played", string>;
}

/** Breakpoints hang from the top; this high. */
const TICK = 7;

/** Draws on a canvas whose context is scaled to CSS pixels. */
export function drawStrip(context: CanvasRenderingContext2D, width: number, height: number, of: Strip): void {
  context.clearRect(0, 0, width, height);
  if (of.length === 0) return;
  const [begin, here] = [pixelOf(0, of.length, width), pixelOf(of.position, of.length, width)];
  context.fillStyle = of.colours.played;
  context.fillRect(begin, 0, here - begin, height);
  const middle = height / 2;
  // Both lanes grow from the middle.
  lane(context, width, of, "insertion", (bar) => [middle - bar * (middle - TICK / 2), middle - 0.5]);
  lane(context, width, of, "flip", (bar) => [middle + 0.5, middle + bar * (middle - 1)]);
  lane(context, width, of, "stage", () => [0, height], 2);
  context.fillStyle = of.colours.breakpoint;
  for (const tick of of.ticks) {
    const x = pixelOf(tick, of.length, width);
    context.beginPath();
    context.moveTo(x - TICK / 2, 0);
    context.lineTo(x + TICK / 2, 0);
    context.lineTo(x, TICK);
    context.fill();
  }
}

function lane(
  context: CanvasRenderingContext2D,
  width: number,
  { moments, length, colours }: Strip,
  kind: MomentKind,
  rows: (height: number) => [top: number, bottom: number],
  thick?: number,
): void {
  context.fillStyle = colours[kind];
  for (const { from, to, height } of bars(moments[kind] ?? [])) {
    const [left, right] = [pixelOf(from * length, length, width), pixelOf(to * length, length, width)];
    const [top, bottom] = rows(height);
    context.fillRect(left, top, thick ?? Math.max(1, right - left), bottom - top);
  }
}
