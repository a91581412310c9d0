// How triangles hang together: half-edges, three for each triangle. Half-edge 3t + k leads from corner k of
// triangle t to the next one; the triangle lies on its left.

import type { Indices } from "../engine/protocol";

/** Stands for no half-edge: beyond lies no triangle. */
export const OUTSIDE = -1;

export class Links {
  /** For each half-edge the one back, in the triangle beyond. */
  readonly twins: Int32Array;
  /** Half-edges by their ends: an open hash table. Ends that occur by the thousand are no matter there. */
  private readonly table: Int32Array;

  /** Linear. Triangles are told with their corners counter-clockwise. */
  constructor(readonly triangles: Indices) {
    this.twins = new Int32Array(triangles.length).fill(OUTSIDE);
    this.table = new Int32Array(2 ** Math.ceil(Math.log2(2 * triangles.length + 2))).fill(OUTSIDE);
    for (let h = 0; h < triangles.length; h++) {
      const [a, b] = [this.origin(h), this.dest(h)];
      const twin = this.find(b, a);
      if (twin !== OUTSIDE) [this.twins[h], this.twins[twin]] = [twin, h];
      this.table[this.slot(a, b)] = h;
    }
  }

  origin = (h: number): number => this.triangles[h];
  dest = (h: number): number => this.triangles[next(h)];
  apex = (h: number): number => this.triangles[previous(h)];

  /** Finds the half-edge from one vertex to another; OUTSIDE if no triangle lies on its left. */
  find(from: number, to: number): number {
    return this.table[this.slot(from, to)];
  }

  /** Returns where a half-edge is, or would be. Half of the table is free, so that this ends. */
  private slot(from: number, to: number): number {
    const mask = this.table.length - 1;
    let at = (Math.imul(from, 0x9e3779b1) ^ Math.imul(to, 0x85ebca6b)) & mask;
    for (;;) {
      const h = this.table[at];
      if (h === OUTSIDE || (this.origin(h) === from && this.dest(h) === to)) return at;
      at = (at + 1) & mask;
    }
  }
}

/** Returns the half-edge after one, around its triangle. */
export const next = (h: number): number => (h % 3 === 2 ? h - 2 : h + 1);

/** Returns the half-edge before one, around its triangle. */
export const previous = (h: number): number => (h % 3 === 0 ? h + 2 : h - 1);
