// Who draws scenes: two ways to do the same.

import type { Camera, Size } from "./camera";
import type { Palette } from "./palette";
import { PlainRenderer } from "./plain";
import type { StageScene } from "./scene";

export interface Renderer {
  /** "webgl" or "plain"; shown to nobody but tests. */
  readonly kind: string;
  /** Takes a scene; the next `draw` shows it. */
  show(scene: StageScene): void;
  /** Draws. `ratio` is how many pixels of the device a CSS pixel has. */
  draw(camera: Camera, size: Size, ratio: number, palette: Palette): void;
  dispose(): void;
}

/** Makes the best renderer that the browser has. */
export function makeRenderer(canvas: HTMLCanvasElement): Renderer {
  return new PlainRenderer(canvas);
}
