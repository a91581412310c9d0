// Huge circles, of which a view sees next to a straight line: the circumcircles of thin triangles are such.

import type { Box } from "./camera";
import type { Spot } from "./clip";

/** In how many lines an arc is drawn. */
const LINES = 64;

/**
 * Returns the part of a huge circle that a box may see, as the points of a line, and two more points that close it to a
 * polygon of what is inside. All pixels. Both are empty if the box sees nothing of the rim and lies outside.
 */
export function arc(center: Spot, radius: number, { low, high }: Box): { rim: Spot[]; inside: Spot[] } {
  const middle: Spot = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  const reach = Math.hypot(high[0] - low[0], high[1] - low[1]);
  const [x, y] = [middle[0] - center[0], middle[1] - center[1]];
  const far = Math.hypot(x, y);
  if (!(far - radius < reach)) return { rim: [], inside: [] };
  const [ux, uy] = far > 0 && far < Number.POSITIVE_INFINITY ? [x / far, y / far] : [1, 0];
  // Counted from the point of the rim that is nearest to the box, along its tangent.
  const nearest = radius - far;
  const half = Math.min(Math.PI, (4 * reach) / radius);
  const at = (angle: number): Spot => {
    const along = radius * Math.sin(angle);
    // 1 - cos, without its cancellation.
    const out = nearest - 2 * radius * Math.sin(angle / 2) ** 2;
    return [middle[0] + ux * out - uy * along, middle[1] + uy * out + ux * along];
  };
  const rim = Array.from({ length: LINES + 1 }, (_, k) => at(half * ((2 * k) / LINES - 1)));
  // Deep inside, and beyond the box in any case.
  const deepest = Math.min(nearest, 0) - 8 * reach;
  const deep = (side: number): Spot => [
    middle[0] + ux * deepest - uy * side,
    middle[1] + uy * deepest + ux * side,
  ];
  return { rim, inside: half < Math.PI ? [deep(4 * reach), deep(-4 * reach)] : [] };
}
