// A pen that draws places of the plane; widths and sizes are CSS pixels.

import type { Coordinates } from "../engine/protocol";
import { type Camera, type Size, toPlane, toScreen } from "./camera";
import type { Palette } from "./palette";

export interface Look {
  fill?: string;
  stroke?: string;
  width?: number;
  /** Lengths of dashes and gaps. */
  dash?: number[];
}

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
    const { context } = this;
    context.beginPath();
    for (let k = 0; k < vertices.length; k++) {
      const v = 2 * vertices[k];
      context.lineTo(...this.at(points[v], points[v + 1]));
    }
    if (vertices.length > 2) context.closePath();
    this.paint(look);
  }

  /** Draws a line through places. */
  path(places: readonly (readonly [number, number])[], look: Look): void {
    this.context.beginPath();
    for (const [x, y] of places) this.context.lineTo(...this.at(x, y));
    this.paint(look);
  }

  circle(x: number, y: number, radius: number, look: Look): void {
    this.context.beginPath();
    this.context.arc(...this.at(x, y), radius * this.camera.scale, 0, 2 * Math.PI);
    this.paint(look);
  }

  dot(x: number, y: number, look: Look & { size: number }): void {
    this.context.beginPath();
    this.context.arc(...this.at(x, y), look.size, 0, 2 * Math.PI);
    this.paint(look);
  }

  label(x: number, y: number, text: string, colour: string): void {
    const [px, py] = this.at(x, y);
    this.context.font = "12px system-ui, sans-serif";
    this.context.lineWidth = 3;
    this.context.setLineDash([]);
    this.context.strokeStyle = this.palette.paper;
    this.context.strokeText(text, px + 6, py - 6);
    this.context.fillStyle = colour;
    this.context.fillText(text, px + 6, py - 6);
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
