// The scenes of the rig.

import type { StageScene } from "../../../src/stage/scene";

/** A point of the UTM scene, not in its middle, where numbers of 32 bits are as good as any; and how far the next number is from its northing. */
export const PLACE = [500_050, 5_400_040] as const;
export const GAP = 2 ** -30;

/** What a surveyor has: large numbers. Two points are 64 numbers apart. */
function utm(): StageScene {
  const [x, y] = PLACE;
  const corners = [x - 20, y - 40, x + 80, y - 40, x + 80, y + 30, x - 20, y + 30];
  return {
    points: Float64Array.of(...corners, x, y, x + 64 * GAP, y),
    edges: Uint32Array.of(0, 4, 1, 4, 2, 5, 3, 4, 4, 5),
    locked: Uint8Array.of(0, 0, 0, 0, 1),
    triangles: Uint32Array.of(0, 1, 4, 3, 0, 4, 1, 2, 5),
    values: null,
    hasDots: true,
  };
}

/** A disc of triangles with all values. */
function values(): StageScene {
  const count = 40;
  const points = new Float64Array(2 * count + 2);
  const [edges, triangles]: [number[], number[]] = [[], []];
  for (let k = 0; k < count; k++) {
    points.set([Math.cos((2 * Math.PI * k) / count), Math.sin((2 * Math.PI * k) / count)], 2 * k + 2);
    const [a, b] = [k + 1, ((k + 1) % count) + 1];
    edges.push(0, a, a, b);
    triangles.push(0, a, b);
  }
  return {
    points,
    edges: Uint32Array.from(edges),
    locked: Uint8Array.from(edges.filter((_, k) => k % 2 === 0).map((_, k) => k % 2)),
    triangles: Uint32Array.from(triangles),
    values: Float32Array.from({ length: count }, (_, k) => k / (count - 1)),
    hasDots: true,
  };
}

/** The same disc as large, or as small, as numbers go. */
const scaled = (unit: number) => (): StageScene => {
  const scene = values();
  return { ...scene, points: scene.points.map((value) => value * unit) };
};

export const scenes: Record<string, () => StageScene> = {
  utm,
  values,
  huge: scaled(1.7e308),
  small: scaled(1e-300),
};
