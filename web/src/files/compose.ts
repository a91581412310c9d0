// The stage as a picture of any size: the scene and what is drawn over it, at the view that is seen now.

import { above, camera, scene, whole } from "../app/Stages";
import type { NamedBytes } from "../engine/protocol";
import { boxOf, fit } from "../stage/camera";
import { readPalette } from "../stage/palette";
import { Pen } from "../stage/pen";
import { PlainRenderer } from "../stage/plain";

/** Draws the stage, again and again, on one canvas. */
export class Composer {
  readonly canvas = document.createElement("canvas");
  private readonly below = document.createElement("canvas");
  private readonly above = document.createElement("canvas");
  private readonly size: { width: number; height: number };
  private readonly ratio: number;
  private readonly element = document.querySelector<HTMLElement>(".stage")!;
  private readonly renderer = new PlainRenderer(this.below);

  /** `width` is that of the picture in pixels; its shape is that of the stage. */
  constructor(width: number) {
    this.size = { width: this.element.clientWidth, height: this.element.clientHeight };
    this.ratio = width / this.size.width;
    // Codecs want even numbers.
    const even = (length: number) => 2 * Math.round((length * this.ratio) / 2);
    Object.assign(this.canvas, { width: even(this.size.width), height: even(this.size.height) });
  }

  draw(): void {
    const { size, ratio } = this;
    const [palette, context] = [readPalette(this.element), this.canvas.getContext("2d")!];
    const view = camera.peek() ?? fit(boxOf(whole.peek()), size);
    this.renderer.show(scene.peek());
    this.renderer.draw(view, size, ratio, palette);
    const pen = new Pen(this.above.getContext("2d")!, this.above, view, size, ratio, palette);
    for (const overlay of above.peek()) overlay(pen);
    context.fillStyle = palette.paper;
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.below, 0, 0);
    context.drawImage(this.above, 0, 0);
  }
}

/** Makes a picture of the stage. */
export async function picture(name: string, width: number): Promise<NamedBytes> {
  const composer = new Composer(width);
  composer.draw();
  const blob = await new Promise<Blob | null>((done) => composer.canvas.toBlob(done, "image/png"));
  if (!blob) throw new Error("the browser makes no picture of this size");
  return { name, bytes: new Uint8Array(await blob.arrayBuffer()) };
}
