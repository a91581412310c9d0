// From a triangle to the one across an edge. Searched for when somebody walks: that is seldom, and nothing has to be kept.

import type { MeshData } from "../engine/protocol";
import { middleOf, placeOf } from "../stage/places";

type Flat = Pick<MeshData, "points" | "triangles">;

/** Returns the triangle across the edge opposite a corner; null on the border. Linear, a few milliseconds for a million. */
export function across({ triangles }: Flat, triangle: number, corner: number): number | null {
  const at = (k: number) => triangles[3 * triangle + ((corner + k) % 3)];
  const [a, b] = [at(1), at(2)];
  for (let t = 0; t < triangles.length; t += 3) {
    if (t === 3 * triangle) continue;
    const [i, j, k] = [triangles[t], triangles[t + 1], triangles[t + 2]];
    // The neighbour has the edge the other way round.
    if ((i === b && j === a) || (j === b && k === a) || (k === b && i === a)) return t / 3;
  }
  return null;
}

/** Returns the corner whose opposite edge lies most in a direction, seen from the middle. */
export function edgeToward(mesh: Flat, triangle: number, [dx, dy]: readonly [number, number]): number {
  const spots = [0, 1, 2].map((k) => placeOf(mesh.points, mesh.triangles[3 * triangle + k]));
  const shares = spots.map((_, k) => {
    const [[ax, ay], [bx, by]] = [spots[(k + 1) % 3], spots[(k + 2) % 3]];
    // Outwards of a triangle that goes counter-clockwise.
    const [nx, ny] = [by - ay, ax - bx];
    return (nx * dx + ny * dy) / Math.max(Math.hypot(nx, ny), Number.MIN_VALUE);
  });
  return shares.indexOf(Math.max(...shares));
}

/** Returns a place within a triangle: its middle. */
export const insideOf = ({ points, triangles }: Flat, triangle: number): [number, number] =>
  middleOf(points, triangles.subarray(3 * triangle, 3 * triangle + 3));
