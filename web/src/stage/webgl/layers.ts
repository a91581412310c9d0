// The layers of a scene, from below: triangles, edges, constraints, dots.

import { relativeCamera } from "../anchor";
import type { Camera, Size } from "../camera";
import { colourOf } from "../colour";
import { DOT_RADIUS, dotsFor, EDGE_FADE, EDGE_WIDTH, LOCKED_WIDTH, leastStrength } from "../density";
import { longerThan } from "../lengths";
import type { Palette } from "../palette";
import { ramp } from "../scale";
import { type Gl, Program, type Uniform } from "./program";
import * as shaders from "./shaders";
import type { Edges, Stock } from "./stock";
import { colourTable } from "./table";

/** What all layers want to know. */
export interface Look {
  camera: Camera;
  size: Size;
  /** How many pixels of the device a CSS pixel has. */
  ratio: number;
  palette: Palette;
}

type Uniforms = Record<string, Uniform>;

export class Layers {
  private readonly triangle: Program;
  private readonly edge: Program;
  private readonly dot: Program;
  private readonly ramp: WebGLTexture;

  /** Throws if the browser does not take the programs. */
  constructor(private readonly gl: Gl) {
    this.triangle = new Program(gl, shaders.triangleVertex, shaders.triangleFragment);
    this.edge = new Program(gl, shaders.edgeVertex, shaders.edgeFragment);
    this.dot = new Program(gl, shaders.dotVertex, shaders.dotFragment);
    this.ramp = colourTable(gl, ramp(256));
  }

  /** Draws all of a stock; the camera sees the plane of its scene. */
  draw(stock: Stock, look: Look): void {
    const { places, scene } = stock;
    if (!places || !scene) return;
    const { size, ratio, palette } = look;
    const eye = relativeCamera(look.camera, stock.anchor);
    const view: Uniforms = {
      places: places.texture,
      middle: [bounded(eye.x), bounded(eye.y)],
      zoom: bounded(eye.scale * ratio),
      size: [size.width * ratio, size.height * ratio],
    };
    this.triangles(stock, view, palette);
    this.edges(stock.ordinary, view, { colour: palette.edge, width: EDGE_WIDTH, fades: true }, eye, ratio);
    this.edges(stock.locked, view, { colour: palette.locked, width: LOCKED_WIDTH, fades: false }, eye, ratio);
    if (scene.hasDots) this.dots(stock, view, eye.scale, look);
  }

  private triangles(stock: Stock, view: Uniforms, palette: Palette): void {
    const { gl } = this;
    if (!stock.corners) return;
    const { texture } = stock.corners;
    this.triangle.use({
      ...view,
      corners: texture,
      // All of them must be there, used or not.
      values: stock.values?.texture ?? this.ramp,
      ramp: this.ramp,
      isValued: stock.values !== null,
      colour: colourOf(palette.fill),
    });
    gl.drawArrays(gl.TRIANGLES, 0, stock.scene!.triangles.length);
  }

  private edges(
    edges: Edges | null,
    view: Uniforms,
    { colour, width, fades }: { colour: string; width: number; fades: boolean },
    eye: Camera,
    ratio: number,
  ): void {
    const { gl } = this;
    if (!edges) return;
    const least = fades ? leastStrength(edges.mean * eye.scale) : 1;
    const shortest = least > 0 ? 0 : EDGE_FADE[0];
    const count = longerThan(edges, shortest / eye.scale);
    if (count === 0) return;
    const halfWidth = (width * ratio) / 2;
    this.edge.use({ ...view, ends: edges.table.texture, colour: colourOf(colour), halfWidth, ratio, least });
    gl.drawArrays(gl.TRIANGLES, 0, 6 * count);
  }

  private dots(stock: Stock, view: Uniforms, scale: number, { ratio, palette }: Look): void {
    const { gl } = this;
    const { points, dotsFrom = 0, edges, triangles } = stock.scene!;
    const { radius, alpha } = dotsFor(stock.spacing * scale, edges.length + triangles.length === 0);
    if (alpha === 0) return;
    const colour = colourOf(palette.ink).map((part) => part * alpha);
    this.dot.use({ ...view, first: dotsFrom, radius: Math.min(radius, DOT_RADIUS) * ratio, colour });
    gl.drawArrays(gl.POINTS, 0, points.length / 2 - dotsFrom);
  }
}

/** Squares of these still are numbers of 32 bits; what they show is nowhere near the view. */
const bounded = (value: number): number => Math.max(-1e15, Math.min(value, 1e15));
