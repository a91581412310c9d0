// The scene drawn on an ordinary canvas, where there is no WebGL.

import { anchorOf, isFine, relativeCamera } from "./anchor";
import { boxOf, type Camera, type Size, toScreen } from "./camera";
import { dotsFor, EDGE_WIDTH, edgeStrength, LOCKED_WIDTH, leastStrength, spacingOf } from "./density";
import { near, windowOf } from "./near";
import type { Palette } from "./palette";
import { Pen } from "./pen";
import type { Renderer } from "./renderer";
import { scale } from "./scale";
import { emptyScene, type StageScene } from "./scene";

/** How many triangles make a path: longer ones take browsers more than their share of time. */
const TRIANGLES = 2048;

/** How many strengths edges fade in. */
const STRENGTHS = 8;

export class PlainRenderer implements Renderer {
  readonly kind = "plain";
  private scene: StageScene = emptyScene;
  private readonly context: CanvasRenderingContext2D;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext("2d")!;
  }

  show(scene: StageScene): void {
    this.scene = scene;
  }

  draw(camera: Camera, size: Size, ratio: number, palette: Palette): void {
    const [scene, eye] = this.nearby(camera, size, ratio);
    drawScene(new Pen(this.context, this.canvas, eye, size, ratio, palette), scene);
  }

  dispose(): void {}

  /** Canvases count in 32 bits as well: looked at very closely, only what is near is drawn. */
  private nearby(camera: Camera, size: Size, ratio: number): [StageScene, Camera] {
    if (isFine(camera, anchorOf(boxOf(this.scene.points)), ratio)) return [this.scene, camera];
    const { scene, anchor } = near(this.scene, windowOf(camera, size));
    return [scene, relativeCamera(camera, anchor)];
  }
}

function drawScene(pen: Pen, scene: StageScene): void {
  const places = pixels(pen, scene.points);
  pen.context.setLineDash([]);
  if (scene.values) valued(pen, scene, places, scene.values);
  else alike(pen, scene, places);
  edges(pen, scene, places);
  if (scene.hasDots) dots(pen, scene, places);
}

function pixels({ camera, size }: Pen, points: Float64Array): Float64Array {
  const places = new Float64Array(points.length);
  for (let i = 0; i < points.length; i += 2) {
    places.set(toScreen(camera, size, points[i], points[i + 1]), i);
  }
  return places;
}

function alike({ context, palette, size }: Pen, { triangles }: StageScene, places: Float64Array): void {
  context.fillStyle = palette.fill;
  context.strokeStyle = palette.fill;
  context.lineWidth = 0.6;
  for (let from = 0; from < triangles.length; from += 3 * TRIANGLES) {
    context.beginPath();
    const to = Math.min(from + 3 * TRIANGLES, triangles.length);
    for (let t = from; t < to; t += 3) trace(context, size, triangles, t, places);
    context.fill();
    // Half-covered pixels along shared edges would let the paper shine through.
    context.stroke();
  }
}

function valued(
  { context, size, palette }: Pen,
  { triangles }: StageScene,
  places: Float64Array,
  values: Float32Array,
): void {
  context.lineWidth = 0.6;
  for (let t = 0; t < triangles.length; t += 3) {
    context.beginPath();
    trace(context, size, triangles, t, places);
    context.fillStyle = context.strokeStyle = values[t / 3] >= 0 ? scale(values[t / 3]) : palette.fill;
    context.fill();
    context.stroke();
  }
}

/** Adds a triangle to the path if it may be seen. */
function trace(
  context: CanvasRenderingContext2D,
  { width, height }: Size,
  triangles: Uint32Array,
  t: number,
  places: Float64Array,
): void {
  const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
  const [ax, bx, cx] = [places[a], places[b], places[c]];
  const [ay, by, cy] = [places[a + 1], places[b + 1], places[c + 1]];
  if ((ax < 0 && bx < 0 && cx < 0) || (ax > width && bx > width && cx > width)) return;
  if ((ay < 0 && by < 0 && cy < 0) || (ay > height && by > height && cy > height)) return;
  context.moveTo(ax, ay);
  context.lineTo(bx, by);
  context.lineTo(cx, cy);
  context.closePath();
}

/** Edges of the same strength are one path. */
function edges({ context, palette, size }: Pen, scene: StageScene, places: Float64Array): void {
  const least = leastStrength(meanLength(scene.edges, places));
  const paths = Array.from({ length: STRENGTHS + 2 }, () => new Path2D());
  for (let e = 0; e < scene.edges.length; e += 2) {
    const [a, b] = [2 * scene.edges[e], 2 * scene.edges[e + 1]];
    const [ax, ay, bx, by] = [places[a], places[a + 1], places[b], places[b + 1]];
    if ((ax < 0 && bx < 0) || (ay < 0 && by < 0)) continue;
    if ((ax > size.width && bx > size.width) || (ay > size.height && by > size.height)) continue;
    const isLocked = scene.locked?.[e / 2] === 1;
    const strength = isLocked
      ? STRENGTHS + 1
      : Math.round(STRENGTHS * edgeStrength(Math.hypot(bx - ax, by - ay), least));
    paths[strength].moveTo(ax, ay);
    paths[strength].lineTo(bx, by);
  }
  context.strokeStyle = palette.edge;
  context.lineWidth = EDGE_WIDTH;
  for (let strength = 1; strength <= STRENGTHS; strength++) {
    context.globalAlpha = strength / STRENGTHS;
    context.stroke(paths[strength]);
  }
  context.globalAlpha = 1;
  context.strokeStyle = palette.locked;
  context.lineWidth = LOCKED_WIDTH;
  context.stroke(paths[STRENGTHS + 1]);
}

function meanLength(edges: Uint32Array, places: Float64Array): number {
  let sum = 0;
  for (let e = 0; e < edges.length; e += 2) {
    const [a, b] = [2 * edges[e], 2 * edges[e + 1]];
    sum += Math.hypot(places[b] - places[a], places[b + 1] - places[a + 1]);
  }
  return (2 * sum) / Math.max(2, edges.length);
}

function dots({ context, camera, palette, size }: Pen, scene: StageScene, places: Float64Array): void {
  const isAlone = scene.edges.length + scene.triangles.length === 0;
  const { radius, alpha } = dotsFor(spacingOf(scene) * camera.scale, isAlone);
  if (alpha === 0) return;
  context.beginPath();
  for (let i = 2 * (scene.dotsFrom ?? 0); i < places.length; i += 2) {
    const [x, y] = [places[i], places[i + 1]];
    if (x < -radius || y < -radius || x > size.width + radius || y > size.height + radius) continue;
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.globalAlpha = alpha;
  context.fillStyle = palette.ink;
  context.fill();
  context.globalAlpha = 1;
}
