// What of a scene lies near the view, cut off and relative to a place there. Looked at so closely that the scene as a
// whole would tremble in numbers of 32 bits, this is drawn in its place.

import { type Anchor, relative } from "./anchor";
import type { Box, Camera, Size } from "./camera";
import { clipLine, clipPolygon, type Spot } from "./clip";
import type { StageScene } from "./scene";

/** A part of a scene; its points are relative to the anchor. */
export interface Near {
  scene: StageScene;
  anchor: Anchor;
}

/** How many views the window is wide, so that moving around does not mean cutting again. */
const VIEWS = 3;

/** The window in its own numbers. */
const WINDOW: Box = { low: [-1, -1], high: [1, 1] };

/** Returns the window around a view. */
export function windowOf({ x, y, scale }: Camera, { width, height }: Size): Anchor {
  return { x, y, unit: ((VIEWS / 2) * Math.max(width, height, 1)) / scale };
}

/** Returns whether a view lies within a window. */
export function isWithin(camera: Camera, { width, height }: Size, { x, y, unit }: Anchor): boolean {
  const half = [width / 2 / camera.scale, height / 2 / camera.scale];
  return Math.abs(camera.x - x) + half[0] <= unit && Math.abs(camera.y - y) + half[1] <= unit;
}

/** Cuts out what lies in a window. Linear in the scene. */
export function near(scene: StageScene, anchor: Anchor): Near {
  const cutter = new Cutter(scene, anchor);
  cutter.triangles();
  cutter.edges();
  // Vertices of pieces are no points of the scene: those come last, and alone are drawn as dots.
  const dotsFrom = cutter.points.length / 2;
  if (scene.hasDots) cutter.dots();
  return { scene: { ...cutter.scene(), dotsFrom }, anchor };
}

class Cutter {
  readonly points: number[] = [];
  private readonly corners: number[] = [];
  private readonly values: number[] = [];
  private readonly ends: number[] = [];
  private readonly locks: number[] = [];

  constructor(
    private readonly whole: StageScene,
    private readonly anchor: Anchor,
  ) {}

  scene(): StageScene {
    const { locked, values, hasDots } = this.whole;
    return {
      points: Float64Array.from(this.points),
      edges: Uint32Array.from(this.ends),
      locked: locked && Uint8Array.from(this.locks),
      triangles: Uint32Array.from(this.corners),
      values: values && Float32Array.from(this.values),
      hasDots,
    };
  }

  triangles(): void {
    const { triangles, values } = this.whole;
    for (let t = 0; t < triangles.length; t += 3) {
      if (!this.mayBeNear(triangles, t, 3)) continue;
      const piece = clipPolygon(
        [0, 1, 2].map((k) => this.spot(triangles[t + k])),
        WINDOW,
      );
      const first = this.points.length / 2;
      for (const spot of piece) this.points.push(...spot);
      for (let k = 2; k < piece.length; k++) {
        this.corners.push(first, first + k - 1, first + k);
        if (values) this.values.push(values[t / 3]);
      }
    }
  }

  edges(): void {
    const { edges, locked } = this.whole;
    for (let e = 0; e < edges.length; e += 2) {
      if (!this.mayBeNear(edges, e, 2)) continue;
      const piece = clipLine(this.spot(edges[e]), this.spot(edges[e + 1]), WINDOW);
      if (!piece) continue;
      const first = this.points.length / 2;
      this.points.push(...piece[0], ...piece[1]);
      this.ends.push(first, first + 1);
      if (locked) this.locks.push(locked[e / 2]);
    }
  }

  dots(): void {
    for (let v = 0; 2 * v < this.whole.points.length; v++) {
      const [x, y] = this.spot(v);
      if (Math.abs(x) <= 1 && Math.abs(y) <= 1) this.points.push(x, y);
    }
  }

  private spot(vertex: number): Spot {
    const { points } = this.whole;
    const { x, y, unit } = this.anchor;
    return [relative(points[2 * vertex], x, unit), relative(points[2 * vertex + 1], y, unit)];
  }

  /** Most are far off to one side, which is quickly seen. */
  private mayBeNear(vertices: Uint32Array, from: number, count: number): boolean {
    const { points } = this.whole;
    const { x, y, unit } = this.anchor;
    let sides = 15;
    for (let k = from; k < from + count; k++) {
      const px = points[2 * vertices[k]];
      const py = points[2 * vertices[k] + 1];
      const left = px < x - unit ? 1 : px > x + unit ? 2 : 0;
      sides &= left | (py < y - unit ? 4 : py > y + unit ? 8 : 0);
    }
    return sides === 0;
  }
}
