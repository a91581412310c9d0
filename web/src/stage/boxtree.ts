// A tree over items with boxes, for searches near a place. Halves of halves by the middles of the boxes, after Bentley's
// k-d tree ("Multidimensional binary search trees used for associative searching", 1975): crowds and lone points make no
// difference to it, as they would to a grid. Built in O(n log n).

import { select } from "./select";

/** Writes left, bottom, right and top of an item's box. */
export type Boxes = (item: number, into: Float64Array) => void;

/** A search: what it wants, and what it has found. */
export interface Search {
  /** What is farther is not looked at; may sink meanwhile. */
  limit: number;
  /** Tells how far a box is, or less. */
  far(left: number, bottom: number, right: number, top: number): number;
  see(item: number): void;
}

/** How many items a leaf has at most. */
const LEAF = 48;

export class BoxTree {
  /** The items; each node has a range of them. */
  private readonly items: Uint32Array;
  /** Four numbers for each node; those below node k are 2k + 1 and 2k + 2. */
  private readonly boxes: Float64Array;

  constructor(
    private readonly count: number,
    boxOf: Boxes,
  ) {
    this.items = new Uint32Array(count).map((_, k) => k);
    let nodes = 1;
    for (let size = count; size > LEAF; size = Math.ceil(size / 2)) nodes = 2 * nodes + 1;
    this.boxes = new Float64Array(4 * nodes);
    if (count > 0) new Builder(this.items, this.boxes, boxOf).build(0, 0, count);
  }

  /** Shows items to a search, those in nearer boxes first. */
  search(search: Search): void {
    if (this.count > 0) this.descend(0, 0, this.count, this.far(0, search), search);
  }

  private far(node: number, search: Search): number {
    const { boxes } = this;
    const b = 4 * node;
    return search.far(boxes[b], boxes[b + 1], boxes[b + 2], boxes[b + 3]);
  }

  private descend(node: number, from: number, to: number, far: number, search: Search): void {
    if (far > search.limit) return;
    if (to - from <= LEAF) {
      for (let k = from; k < to; k++) search.see(this.items[k]);
      return;
    }
    const middle = middleOf(from, to);
    const [first, second] = [2 * node + 1, 2 * node + 2];
    const [a, b] = [this.far(first, search), this.far(second, search)];
    if (a <= b) this.descend(first, from, middle, a, search);
    this.descend(second, middle, to, b, search);
    if (a > b) this.descend(first, from, middle, a, search);
  }
}

const middleOf = (from: number, to: number): number => (from + to + 1) >>> 1;

class Builder {
  /** The middles of the items' boxes, in the order of the items. */
  private readonly x: Float64Array;
  private readonly y: Float64Array;
  private readonly box = new Float64Array(4);

  constructor(
    private readonly items: Uint32Array,
    private readonly boxes: Float64Array,
    private readonly boxOf: Boxes,
  ) {
    this.x = new Float64Array(items.length);
    this.y = new Float64Array(items.length);
    for (let k = 0; k < items.length; k++) {
      boxOf(k, this.box);
      this.x[k] = this.box[0] / 2 + this.box[2] / 2;
      this.y[k] = this.box[1] / 2 + this.box[3] / 2;
    }
  }

  build(node: number, from: number, to: number): void {
    if (to - from <= LEAF) {
      this.fill(node, from, to);
      return;
    }
    const middle = middleOf(from, to);
    const [by, other] = this.isWide(from, to) ? [this.x, this.y] : [this.y, this.x];
    select(by, other, this.items, middle, from, to - 1);
    this.build(2 * node + 1, from, middle);
    this.build(2 * node + 2, middle, to);
    this.join(node);
  }

  private isWide(from: number, to: number): boolean {
    const { x, y } = this;
    let [left, right, bottom, top] = [x[from], x[from], y[from], y[from]];
    for (let k = from + 1; k < to; k++) {
      if (x[k] < left) left = x[k];
      else if (x[k] > right) right = x[k];
      if (y[k] < bottom) bottom = y[k];
      else if (y[k] > top) top = y[k];
    }
    return right / 2 - left / 2 >= top / 2 - bottom / 2;
  }

  private fill(node: number, from: number, to: number): void {
    const { box, boxes, boxOf, items } = this;
    const b = 4 * node;
    boxOf(items[from], box);
    boxes.set(box, b);
    for (let k = from + 1; k < to; k++) {
      boxOf(items[k], box);
      if (box[0] < boxes[b]) boxes[b] = box[0];
      if (box[1] < boxes[b + 1]) boxes[b + 1] = box[1];
      if (box[2] > boxes[b + 2]) boxes[b + 2] = box[2];
      if (box[3] > boxes[b + 3]) boxes[b + 3] = box[3];
    }
  }

  private join(node: number): void {
    const { boxes } = this;
    const [b, first, second] = [4 * node, 8 * node + 4, 8 * node + 8];
    boxes[b] = Math.min(boxes[first], boxes[second]);
    boxes[b + 1] = Math.min(boxes[first + 1], boxes[second + 1]);
    boxes[b + 2] = Math.max(boxes[first + 2], boxes[second + 2]);
    boxes[b + 3] = Math.max(boxes[first + 3], boxes[second + 3]);
  }
}
