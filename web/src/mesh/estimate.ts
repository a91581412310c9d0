// How many triangles will come, before they come: good enough to warn.

import type { DrawingData, MeshKind, MeshOptions } from "../engine/protocol";
import { boxOf } from "../stage/camera";
import { nice } from "./numbers";

/** More triangles than this a page handles badly. */
export const MANY = 2e6;

/** Vertices beyond which refinement stops unless something else is asked for. */
export const USUAL_LIMIT = 1_000_000;

/** What a triangle covers on average, as part of the largest that it may be: measured on squares. */
const PART_OF_AREA = 0.93;
/** The same for the area of a triangle whose three edges are as long as they may be. */
const PART_OF_EDGE = 0.86;

/** How long the diagonal of a drawing is, and what its box covers. */
export function extent(points: Float64Array): { diagonal: number; area: number } {
  const { low, high } = boxOf(points);
  const [width, height] = [high[0] - low[0], high[1] - low[1]];
  return { diagonal: Math.hypot(width, height), area: width * height };
}

/** Suggests a longest edge and a largest area: a fortieth of the diagonal, and the triangle that goes with it. */
export function suggestions(points: Float64Array): { maxEdge: number; maxArea: number } {
  const edge = extent(points).diagonal / 40;
  return { maxEdge: nice(edge), maxArea: nice((Math.sqrt(3) / 4) * edge * edge) };
}

/** Estimates how many triangles there will be; null if only their angles matter. `area` is what they are to cover. */
export function estimate(
  drawing: Pick<DrawingData, "points">,
  area: number,
  kind: MeshKind,
  { maxEdge, maxArea }: MeshOptions,
): number | null {
  const fewest = Math.max(drawing.points.length - 2, 0);
  if (kind !== "refine") return fewest;
  const sizes: number[] = [];
  if (maxArea) sizes.push(PART_OF_AREA * maxArea);
  if (maxEdge) sizes.push(PART_OF_EDGE * (Math.sqrt(3) / 4) * maxEdge * maxEdge);
  if (sizes.length === 0) return null;
  // Sizes may be so small that their square is nothing.
  return Math.max(fewest, area / Math.max(Math.min(...sizes), Number.MIN_VALUE));
}
