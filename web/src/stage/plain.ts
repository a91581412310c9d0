// The scene drawn on an ordinary canvas, where there is no WebGL.

import type { Camera, Size } from "./camera";
import type { Palette } from "./palette";
import { Pen } from "./pen";
import type { Renderer } from "./renderer";
import { emptyScene, type StageScene } from "./scene";

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
    const pen = new Pen(this.context, this.canvas, camera, size, ratio, palette);
    const { points, edges, locked, triangles, hasDots } = this.scene;
    for (let t = 0; t < triangles.length; t += 3) {
      pen.polygon(points, triangles.subarray(t, t + 3), { fill: palette.fill });
    }
    for (let e = 0; e < edges.length; e += 2) {
      const isLocked = locked?.[e / 2] === 1;
      const look = isLocked ? { stroke: palette.locked, width: 2.5 } : { stroke: palette.edge, width: 1 };
      pen.polygon(points, edges.subarray(e, e + 2), look);
    }
    if (!hasDots) return;
    for (let i = 0; i < points.length; i += 2)
      pen.dot(points[i], points[i + 1], { fill: palette.ink, size: 2.5 });
  }

  dispose(): void {}
}
