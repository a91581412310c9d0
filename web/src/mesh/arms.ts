// The angle between two segments at a corner, as an arc.

import type { DrawingData } from "../engine/protocol";

export type Spot = [x: number, y: number];

/** Into how many pieces an arc is divided. */
const PIECES = 24;

/** Degrees by which an angle may differ from what it is said to be: both are rounded. */
const ROUNDING = 0.1;

/**
 * Returns the arc at a point between two segments, with a radius. A segment may go on beyond the point: the arms are those
 * between which there are as many degrees as is said. Null if there are none.
 */
export function arcBetween(
  { points, segments }: Pick<DrawingData, "points" | "segments">,
  point: number,
  pair: readonly [number, number],
  degrees: number,
  radius: number,
): Spot[] | null {
  const [x, y] = [points[2 * point], points[2 * point + 1]];
  const arms = pair.map((k) =>
    [segments[2 * k], segments[2 * k + 1]]
      .map((v) => [points[2 * v] - x, points[2 * v + 1] - y])
      .filter(([dx, dy]) => dx !== 0 || dy !== 0)
      .map(([dx, dy]) => Math.atan2(dy, dx)),
  );
  for (const from of arms[0]) {
    for (const to of arms[1]) {
      // By the shorter way.
      const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
      if (Math.abs(Math.abs(turn) - (degrees * Math.PI) / 180) > (ROUNDING * Math.PI) / 180) continue;
      return Array.from({ length: PIECES + 1 }, (_, k): Spot => {
        const at = from + (turn * k) / PIECES;
        return [x + radius * Math.cos(at), y + radius * Math.sin(at)];
      });
    }
  }
  return null;
}
