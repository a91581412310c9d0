// What of a scene is at a place, or near it. Distances are measured from that place in units of the radius, so that they
// are good numbers however large or small the coordinates are. No decision about topology is made here: what is near to
// a finger is no matter of the last bit.

import type { Coordinates, Indices } from "../engine/protocol";
import { relative } from "./anchor";
import { type Boxes, BoxTree, type Search } from "./boxtree";
import type { StageScene } from "./scene";

/** What is searched: the lists of a scene. */
export type Lists = Pick<StageScene, "points" | "edges" | "triangles">;

/** Finds vertices, edges and triangles of a scene. Each kind of search sorts the scene at its first question. */
export class Picker {
  private vertices: BoxTree | undefined;
  private edges: BoxTree | undefined;
  private triangles: BoxTree | undefined;

  constructor(readonly scene: Lists) {}

  /** Returns the vertex nearest to a place, not farther than `radius`; of several the first. */
  vertex(x: number, y: number, radius: number): number | null {
    const { points } = this.scene;
    this.vertices ??= new BoxTree(points.length / 2, pointBoxes(points));
    return nearest(this.vertices, x, y, radius, (v, rx, ry) => {
      const [dx, dy] = [rx(points[2 * v]), ry(points[2 * v + 1])];
      return dx * dx + dy * dy;
    });
  }

  /** Returns the edge nearest to a place, not farther than `radius`; of several the first. */
  edge(x: number, y: number, radius: number): number | null {
    const { points, edges } = this.scene;
    this.edges ??= new BoxTree(edges.length / 2, edgeBoxes(points, edges));
    return nearest(this.edges, x, y, radius, (e, rx, ry) => {
      const [a, b] = [2 * edges[2 * e], 2 * edges[2 * e + 1]];
      return toLine(rx(points[a]), ry(points[a + 1]), rx(points[b]), ry(points[b + 1]));
    });
  }

  /** Returns the triangle at a place; of several, that share an edge there, the first. */
  triangle(x: number, y: number): number | null {
    const { points, triangles } = this.scene;
    const boxOf = triangleBoxes(points, triangles);
    this.triangles ??= new BoxTree(triangles.length / 3, boxOf);
    const box = new Float64Array(4);
    let found: number | null = null;
    this.triangles.search({
      limit: 0,
      far: (left, bottom, right, top) => (left <= x && x <= right && bottom <= y && y <= top ? 0 : 1),
      see(t) {
        boxOf(t, box);
        if (x < box[0] || y < box[1] || x > box[2] || y > box[3]) return;
        if ((found === null || t < found) && holds(points, triangles, t, x, y)) found = t;
      },
    });
    return found;
  }
}

const pickers = new WeakMap<Coordinates, Picker>();

/** Returns the picker of a scene; the same one as long as points, edges and triangles are the same. */
export function pickerOf(scene: Lists): Picker {
  const known = pickers.get(scene.points);
  if (known?.scene.edges === scene.edges && known.scene.triangles === scene.triangles) return known;
  const picker = new Picker(scene);
  pickers.set(scene.points, picker);
  return picker;
}

type Relative = (value: number) => number;

/** Finds the item of the least distance, which `measure` tells as a square, in units of the radius. */
function nearest(
  tree: BoxTree,
  x: number,
  y: number,
  radius: number,
  measure: (item: number, rx: Relative, ry: Relative) => number,
): number | null {
  const rx = (value: number) => relative(value, x, radius);
  const ry = (value: number) => relative(value, y, radius);
  let found: number | null = null;
  const search: Search = {
    limit: 1,
    far(left, bottom, right, top) {
      const dx = Math.max(rx(left), -rx(right), 0);
      const dy = Math.max(ry(bottom), -ry(top), 0);
      return dx * dx + dy * dy;
    },
    see(item) {
      const far = measure(item, rx, ry);
      if (far > search.limit || (far === search.limit && found !== null && found < item)) return;
      search.limit = far;
      found = item;
    },
  };
  if (radius > 0) tree.search(search);
  return found;
}

/** Returns the square of the distance of a line from the origin. */
function toLine(ax: number, ay: number, bx: number, by: number): number {
  const [x, y] = [bx - ax, by - ay];
  const length = Math.hypot(x, y);
  if (length === 0) return ax * ax + ay * ay;
  const [ux, uy] = [x / length, y / length];
  const along = -(ax * ux + ay * uy);
  if (along <= 0) return ax * ax + ay * ay;
  if (along >= length) return bx * bx + by * by;
  return (ax * uy - ay * ux) ** 2;
}

/** Whether a triangle holds a place. Of two that share an edge, one does at least: their signs are opposite exactly. */
function holds(points: Coordinates, triangles: Indices, t: number, x: number, y: number): boolean {
  const ways = [0, 1, 2].flatMap((k) => {
    const v = 2 * triangles[3 * t + k];
    return [points[v] / 2 - x / 2, points[v + 1] / 2 - y / 2];
  });
  const [ax, ay, bx, by, cx, cy] = scaled(ways);
  const signs = [ax * by - bx * ay, bx * cy - cx * by, cx * ay - ax * cy];
  // A flat triangle holds nothing.
  return signs.every((sign) => sign >= 0) !== signs.every((sign) => sign <= 0);
}

/** Multiplies by a power of two, which rounds nothing, such that products are good numbers. */
function scaled(ways: number[]): number[] {
  const most = Math.max(...ways.map(Math.abs), 2 ** -1022);
  const factor = 2 ** -Math.floor(Math.log2(most));
  return ways.map((way) => way * factor);
}

const pointBoxes =
  (points: Coordinates): Boxes =>
  (v, into) => {
    into[0] = into[2] = points[2 * v];
    into[1] = into[3] = points[2 * v + 1];
  };

const edgeBoxes =
  (points: Coordinates, edges: Indices): Boxes =>
  (e, into) => {
    const [a, b] = [2 * edges[2 * e], 2 * edges[2 * e + 1]];
    into[0] = Math.min(points[a], points[b]);
    into[1] = Math.min(points[a + 1], points[b + 1]);
    into[2] = Math.max(points[a], points[b]);
    into[3] = Math.max(points[a + 1], points[b + 1]);
  };

const triangleBoxes =
  (points: Coordinates, triangles: Indices): Boxes =>
  (t, into) => {
    const [a, b, c] = [2 * triangles[3 * t], 2 * triangles[3 * t + 1], 2 * triangles[3 * t + 2]];
    into[0] = Math.min(points[a], points[b], points[c]);
    into[1] = Math.min(points[a + 1], points[b + 1], points[c + 1]);
    into[2] = Math.max(points[a], points[b], points[c]);
    into[3] = Math.max(points[a + 1], points[b + 1], points[c + 1]);
  };
