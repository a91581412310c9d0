// Who draws scenes: two ways to do the same, and how one of them is chosen.

import type { Camera, Size } from "./camera";
import type { Palette } from "./palette";
import { PlainRenderer } from "./plain";
import { emptyScene, type StageScene } from "./scene";
import { WebglRenderer } from "./webgl/webgl";

export interface Renderer {
  /** "webgl" or "plain"; shown to nobody but tests, as `data-renderer` of the canvas. */
  readonly kind: string;
  /** Takes a scene; the next `draw` shows it. */
  show(scene: StageScene): void;
  /** Draws. `ratio` is how many pixels of the device a CSS pixel has. */
  draw(camera: Camera, size: Size, ratio: number, palette: Palette): void;
  dispose(): void;
}

/**
 * Makes the best renderer that the browser has, with a canvas in `host`: WebGL, unless `?plain` stands in the address.
 * `stale` is called when the scene must be drawn again.
 */
export function makeRenderer(host: HTMLElement, stale: () => void): Renderer {
  return new Steady(host, stale);
}

/** Goes on with an ordinary canvas where there is no WebGL, none any more, or not enough of it. */
class Steady implements Renderer {
  private inner: Renderer;
  private scene: StageScene = emptyScene;

  constructor(
    private readonly host: HTMLElement,
    private readonly stale: () => void,
  ) {
    this.inner = this.makeWebgl() ?? this.makePlain();
  }

  get kind(): string {
    return this.inner.kind;
  }

  show(scene: StageScene): void {
    this.scene = scene;
    this.inner.show(scene);
  }

  draw(...how: [camera: Camera, size: Size, ratio: number, palette: Palette]): void {
    try {
      this.inner.draw(...how);
    } catch (error) {
      if (!(error instanceof RangeError) || this.kind === "plain") throw error;
      this.giveUp();
      this.inner.draw(...how);
    }
  }

  dispose(): void {
    this.inner.dispose();
    this.host.replaceChildren();
  }

  /** A canvas keeps its first kind of context for ever: another kind needs another canvas. */
  private canvas(kind: string): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.dataset.renderer = kind;
    this.host.replaceChildren(canvas);
    return canvas;
  }

  private makePlain(): Renderer {
    return new PlainRenderer(this.canvas("plain"));
  }

  private makeWebgl(): Renderer | null {
    if (new URLSearchParams(location.search).has("plain")) return null;
    const canvas = this.canvas("webgl");
    const gl = canvas.getContext("webgl2", {
      antialias: false,
      depth: false,
      powerPreference: "high-performance",
    });
    if (!gl) return null;
    try {
      return new WebglRenderer(canvas, gl, {
        stale: this.stale,
        lost: () => {
          this.giveUp();
          this.stale();
        },
      });
    } catch {
      return null;
    }
  }

  private giveUp(): void {
    this.inner.dispose();
    this.inner = this.makePlain();
    this.inner.show(this.scene);
  }
}
