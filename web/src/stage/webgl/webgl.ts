// The scene drawn by the graphics processor. Panning and zooming upload nothing; only who looks so closely that numbers
// of 32 bits would show gets what is near the view uploaded, too (`near.ts`). A context that is lost comes back with
// everything in it.

import { isFine, relativeCamera } from "../anchor";
import type { Camera, Size } from "../camera";
import { isWithin, type Near, near, windowOf } from "../near";
import type { Palette } from "../palette";
import type { Renderer } from "../renderer";
import { emptyScene, type StageScene } from "../scene";
import { Layers } from "./layers";
import type { Gl } from "./program";
import { Stock } from "./stock";

/** What a renderer tells its owner. */
export interface Calls {
  /** It must be drawn again. */
  stale(): void;
  /** It will not come back. */
  lost(): void;
}

/** Milliseconds after which a lost context counts as lost for good. */
const PATIENCE = 4000;

interface Living {
  layers: Layers;
  whole: Stock;
  part: Stock;
}

export class WebglRenderer implements Renderer {
  readonly kind = "webgl";
  private scene: StageScene = emptyScene;
  private living: Living | null;
  private near: Near | null = null;
  private uploads = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly deaf = new AbortController();

  /** Throws if the browser does not take the programs. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly gl: Gl,
    private readonly calls: Calls,
  ) {
    this.living = this.live();
    const { signal } = this.deaf;
    canvas.addEventListener("webglcontextlost", (event) => this.lose(event), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.restore(), { signal });
  }

  show(scene: StageScene): void {
    if (scene !== this.scene) this.near = null;
    this.scene = scene;
  }

  draw(camera: Camera, size: Size, ratio: number, palette: Palette): void {
    const { gl, canvas, living } = this;
    if (!living || gl.isContextLost()) return;
    const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const look = { camera, size, ratio, palette };
    living.whole.take(this.scene);
    if (isFine(camera, living.whole.anchor, ratio)) {
      // What was near once is not worth its memory any more.
      living.part.clear();
      this.near = null;
      living.layers.draw(living.whole, look);
      return;
    }
    const { scene, anchor } = this.nearby(camera, size, ratio);
    living.part.take(scene);
    living.layers.draw(living.part, { ...look, camera: relativeCamera(camera, anchor) });
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.deaf.abort();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private live(): Living {
    const count = () => {
      this.uploads += 1;
      this.canvas.dataset.uploads = String(this.uploads);
    };
    const { gl } = this;
    return { layers: new Layers(gl), whole: new Stock(gl, count), part: new Stock(gl, count) };
  }

  private nearby(camera: Camera, size: Size, ratio: number): Near {
    const kept = this.near;
    if (kept && isWithin(camera, size, kept.anchor) && isFine(camera, kept.anchor, ratio)) return kept;
    this.near = near(this.scene, windowOf(camera, size));
    return this.near;
  }

  private lose(event: Event): void {
    // Otherwise it would never come back.
    event.preventDefault();
    this.living = null;
    this.near = null;
    this.timer = setTimeout(() => this.calls.lost(), PATIENCE);
  }

  private restore(): void {
    clearTimeout(this.timer);
    try {
      this.living = this.live();
      this.calls.stale();
    } catch {
      this.calls.lost();
    }
  }
}
