// How much of a crowd is shown: edges and dots that would only make a carpet fade away.

import { boxOf, middleOf } from "./camera";
import type { StageScene } from "./scene";

/** In a crowd, edges below the first length, in CSS pixels, are not seen; from the second on they are seen fully. */
export const EDGE_FADE = [2, 10] as const;

/** Edges are a crowd if they are as long as the first on average, and none from the second on. */
const CROWD = [8, 24] as const;

/** The widths of lines and the radius of dots, in CSS pixels. */
export const EDGE_WIDTH = 1;
export const LOCKED_WIDTH = 2.5;
export const DOT_RADIUS = 2.5;

/** Returns how well any edge is seen, from 0 to 1, where edges have a length in CSS pixels on average. */
export const leastStrength = (mean: number): number => smoothstep(...CROWD, mean);

/** Returns how well an edge of a length in CSS pixels is seen, from 0 to 1, where none is seen less than `least`. */
export const edgeStrength = (length: number, least: number): number =>
  least + (1 - least) * smoothstep(...EDGE_FADE, length);

/** How a dot is drawn. */
export interface Dots {
  /** In CSS pixels. */
  radius: number;
  alpha: number;
}

/** Returns how dots are drawn that are about so many pixels apart; if nothing else is drawn they must not vanish. */
export function dotsFor(spacing: number, isAlone: boolean): Dots {
  const alpha = smoothstep(4, 9, spacing);
  if (!isAlone) return { radius: DOT_RADIUS, alpha };
  return {
    radius: Math.max(0.6, Math.min(0.3 * spacing, DOT_RADIUS)),
    alpha: Math.max(0.5, alpha),
  };
}

/** Returns how far the points of a scene are from each other, if they were spread evenly. */
export function spacingOf({ points, dotsFrom = 0 }: StageScene): number {
  const [width, height] = middleOf(boxOf(points)).half;
  const count = Math.max(1, points.length / 2 - dotsFrom);
  return 2 * Math.max(Math.sqrt(width / count) * Math.sqrt(height), Math.max(width, height) / count);
}

function smoothstep(from: number, to: number, value: number): number {
  const t = Math.max(0, Math.min((value - from) / (to - from), 1));
  return t * t * (3 - 2 * t);
}
