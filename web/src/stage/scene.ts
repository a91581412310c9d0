// What the stage shows: lists of points, edges and triangles, whoever made them.

import type { Coordinates, Indices } from "../engine/protocol";

export interface StageScene {
  points: Coordinates;
  edges: Indices;
  /** For each edge 1 if it is a constraint, else 0; null: none is. */
  locked: Uint8Array | null;
  triangles: Indices;
  /** For each triangle from 0 (bad) to 1 (good), to be coloured by; below 0: as if there were none; null: all alike. */
  values: Float32Array | null;
  /** Whether points are drawn as dots. */
  hasDots: boolean;
  /** The first point that is drawn as a dot; usually 0. */
  dotsFrom?: number;
}

const none = new Uint32Array();

/** Points and segments, as they are drawn. */
export function sceneOfDrawing(points: Coordinates, segments: Indices): StageScene {
  const locked = new Uint8Array(segments.length / 2).fill(1);
  return { points, edges: segments, locked, triangles: none, values: null, hasDots: true };
}

export const emptyScene: StageScene = sceneOfDrawing(new Float64Array(), none);
