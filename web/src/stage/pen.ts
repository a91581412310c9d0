// A pen that draws places of the plane; widths and sizes are CSS pixels. Canvases count in 32 bits: what reaches far
// beyond the view is cut off before they round it.

import type { Coordinates } from "../engine/protocol";
import { arc } from "./arc";
import { type Box, type Camera, type Size, toPlane, toScreen } from "./camera";
import { clipLine, clipPolygon, type Spot } from "./clip";
import type { Palette } from "./palette";

export interface Look {
  fill?: string;
  stroke?: string;
  width?: number;
  /** Lengths of dashes and gaps. */
  dash?: number[];
}

/** Beyond so many pixels a canvas would round too much. */
const FAR = 2 ** 15;

/** How far around the view things are still drawn, in pixels: more than any line is wide. */
const AROUND = 64;

/** So many edges are drawn in one stroke: canvases are slow with long paths as they are with many short ones. */
const STROKE = 128;

export class Pen {
  constructor(
    readonly context: CanvasRenderingContext2D,
    canvas: HTMLCanvasElement,
    readonly camera: Camera,
    readonly size: Size,
    ratio: number,
    readonly palette: Palette,
  ) {
    const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
    // Setting a size clears the canvas, and takes time.
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, size.width, size.height);
    context.lineJoin = "round";
    context.lineCap = "round";
  }

  /** The box of the plane that is seen. */
  get seen(): { low: [number, number]; high: [number, number] } {
    const { width, height } = this.size;
    return {
      low: toPlane(this.camera, this.size, 0, height),
      high: toPlane(this.camera, this.size, width, 0),
    };
  }

  at(x: number, y: number): [number, number] {
    return toScreen(this.camera, this.size, x, y);
  }

  /** Draws the polygon through vertices; with two, the edge between them. */
  polygon(points: Coordinates, vertices: ArrayLike<number>, look: Look): void {
    const spots: Spot[] = [];
    for (let k = 0; k < vertices.length; k++) {
      const v = 2 * vertices[k];
      spots.push(this.at(points[v], points[v + 1]));
    }
    if (vertices.length > 2) this.closed(spots, look);
    else this.open(spots, look);
  }

  /** Draws edges, two vertices each: thousands of them in a few strokes. Where they overlap they are no darker. */
  edges(points: Coordinates, pairs: ArrayLike<number>, look: Look): void {
    for (let from = 0; from < pairs.length; from += 2 * STROKE) {
      this.context.beginPath();
      const end = Math.min(pairs.length, from + 2 * STROKE);
      for (let k = from; k < end; k += 2) {
        const [a, b] = [2 * pairs[k], 2 * pairs[k + 1]];
        this.pieces([this.at(points[a], points[a + 1]), this.at(points[b], points[b + 1])]);
      }
      this.paint(look);
    }
  }

  /** Draws a line through places. */
  path(places: readonly (readonly [number, number])[], look: Look): void {
    this.open(
      places.map(([x, y]) => this.at(x, y)),
      look,
    );
  }

  /** Draws an upright or a level line from one side of the view to the other. */
  across(where: { vertical: number } | { horizontal: number }, look: Look): void {
    const { low, high } = this.seen;
    const isUpright = "vertical" in where;
    const from = isUpright ? [where.vertical, low[1]] : [low[0], where.horizontal];
    const to = isUpright ? [where.vertical, high[1]] : [high[0], where.horizontal];
    this.path([from as [number, number], to as [number, number]], look);
  }

  circle(x: number, y: number, radius: number, look: Look): void {
    const [px, py] = this.at(x, y);
    const size = radius * this.camera.scale;
    if (Math.max(size, Math.abs(px), Math.abs(py)) < FAR) {
      this.context.beginPath();
      this.context.arc(px, py, size, 0, 2 * Math.PI);
      this.paint(look);
      return;
    }
    const { rim, inside } = arc([px, py], size, this.around);
    if (look.fill) this.closed([...rim, ...inside], { fill: look.fill });
    this.open(rim, { ...look, fill: "" });
  }

  dot(x: number, y: number, look: Look & { size: number }): void {
    const [px, py] = this.at(x, y);
    if (Math.max(Math.abs(px), Math.abs(py)) > FAR) return;
    this.context.beginPath();
    this.context.arc(px, py, look.size, 0, 2 * Math.PI);
    this.paint(look);
  }

  /** Draws a lying cross; `size` is half of its width. */
  cross(x: number, y: number, { size, ...look }: Look & { size: number }): void {
    const [px, py] = this.at(x, y);
    this.open(
      [
        [px - size, py - size],
        [px + size, py + size],
      ],
      look,
    );
    this.open(
      [
        [px - size, py + size],
        [px + size, py - size],
      ],
      look,
    );
  }

  label(x: number, y: number, text: string, colour: string): void {
    const [px, py] = this.at(x, y);
    if (Math.max(Math.abs(px), Math.abs(py)) > FAR) return;
    this.context.font = "12px system-ui, sans-serif";
    this.context.lineWidth = 3;
    this.context.setLineDash([]);
    this.context.strokeStyle = this.palette.paper;
    this.context.strokeText(text, px + 6, py - 6);
    this.context.fillStyle = colour;
    this.context.fillText(text, px + 6, py - 6);
  }

  private get around(): Box {
    const { width, height } = this.size;
    return { low: [-AROUND, -AROUND], high: [width + AROUND, height + AROUND] };
  }

  private closed(spots: readonly Spot[], look: Look): void {
    this.context.beginPath();
    for (const [px, py] of spots.some(isFar) ? clipPolygon(spots, this.around) : spots) {
      this.context.lineTo(px, py);
    }
    this.context.closePath();
    this.paint(look);
  }

  private open(spots: readonly Spot[], look: Look): void {
    this.context.beginPath();
    if (spots.some(isFar)) this.pieces(spots);
    else for (const [px, py] of spots) this.context.lineTo(px, py);
    this.paint(look);
  }

  /** Adds what is near of each line; those that go on without a gap stay joined. */
  private pieces(spots: readonly Spot[]): void {
    let last: Spot | undefined;
    for (let k = 1; k < spots.length; k++) {
      const piece = clipLine(spots[k - 1], spots[k], this.around);
      if (!piece) continue;
      if (piece[0] !== last) this.context.moveTo(...piece[0]);
      this.context.lineTo(...piece[1]);
      last = piece[1];
    }
  }

  private paint({ fill, stroke, width = 1, dash = [] }: Look): void {
    if (fill) {
      this.context.fillStyle = fill;
      this.context.fill();
    }
    if (stroke) {
      this.context.strokeStyle = stroke;
      this.context.lineWidth = width;
      this.context.setLineDash(dash);
      this.context.stroke();
    }
  }
}

const isFar = ([px, py]: Spot): boolean => !(Math.abs(px) < FAR && Math.abs(py) < FAR);
