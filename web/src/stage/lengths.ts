// Edges in the order of their lengths, roughly: whoever zooms out draws the first of them only.

import type { Coordinates, Indices } from "../engine/protocol";
import { type Anchor, relative } from "./anchor";
import type { StageScene } from "./scene";

/** Edges by length: class k has those of less than 2^(TOP-k) units and at least half of that, the last one also shorter ones. */
export interface Sorted {
  edges: Indices;
  /** How many edges the classes up to each one have. */
  until: Uint32Array;
  /** How long they are on average, in units. */
  mean: number;
}

const TOP = 3;
const CLASSES = 64;

/** Splits the edges of a scene into ordinary and locked ones, both sorted. Linear. */
export function sortEdges(scene: StageScene, anchor: Anchor): { ordinary: Sorted; locked: Sorted } {
  const { points, edges, locked } = scene;
  const classes = new Uint8Array(edges.length / 2);
  const sums = [0, 0];
  for (let e = 0; e < classes.length; e++) {
    const length = lengthOf(points, edges[2 * e], edges[2 * e + 1], anchor);
    const side = locked?.[e] ? 1 : 0;
    classes[e] = classOf(length) + CLASSES * side;
    sums[side] += length;
  }
  const starts = countUp(classes);
  const sorted = new Uint32Array(edges.length);
  const next = starts.slice();
  for (let e = 0; e < classes.length; e++) {
    const at = 2 * next[classes[e]]++;
    sorted[at] = edges[2 * e];
    sorted[at + 1] = edges[2 * e + 1];
  }
  const split = starts[CLASSES];
  return {
    ordinary: {
      edges: sorted.subarray(0, 2 * split),
      until: next.slice(0, CLASSES),
      mean: sums[0] / Math.max(1, split),
    },
    locked: {
      edges: sorted.subarray(2 * split),
      until: next.slice(CLASSES).map((end) => end - split),
      mean: sums[1] / Math.max(1, classes.length - split),
    },
  };
}

/** Returns how many of sorted edges may be longer than a length in units. */
export function longerThan({ until }: Pick<Sorted, "until">, length: number): number {
  const last = Math.floor(TOP - Math.log2(length));
  return last < 0 ? 0 : until[Math.min(last, CLASSES - 1)];
}

function lengthOf(points: Coordinates, a: number, b: number, { unit }: Anchor): number {
  const x = relative(points[2 * a], points[2 * b], unit);
  const y = relative(points[2 * a + 1], points[2 * b + 1], unit);
  return Math.sqrt(x * x + y * y);
}

function classOf(length: number): number {
  const power = Math.floor(Math.log2(length)) + 1;
  return Math.max(0, Math.min(TOP - power, CLASSES - 1));
}

/** Returns for each class how many items are in those before it. */
function countUp(classes: Uint8Array): Uint32Array {
  const starts = new Uint32Array(2 * CLASSES + 1);
  for (const each of classes) starts[each + 1]++;
  for (let k = 1; k < starts.length; k++) starts[k] += starts[k - 1];
  return starts.subarray(0, 2 * CLASSES);
}
