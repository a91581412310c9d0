// A picture of what is seen: the canvases of all stages on the page, beside each other as they are there.

import { ratio } from "./surroundings";

/** A stage on the page. */
export interface Shown {
  frame: HTMLElement;
  /** Draws both canvases anew: what graphics processors have drawn is gone after the frame. */
  draw(): void;
}

/** All stages on the page; each puts itself in. */
export const shown = new Set<Shown>();

/**
 * Takes a picture of what the stages show now, as PNG, at the resolution of the screen. Throws if there is nothing to see,
 * or the browser has no room for it.
 */
export async function picture(): Promise<Blob> {
  const stages = [...shown].filter(({ frame }) => frame.clientWidth > 0 && frame.clientHeight > 0);
  if (stages.length === 0) throw new Error("there is no stage to take a picture of");
  const canvas = compose(stages);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
  if (!blob) throw new Error("the browser could not write the picture");
  return blob;
}

function compose(stages: Shown[]): HTMLCanvasElement {
  const boxes = stages.map(({ frame }) => frame.getBoundingClientRect());
  const [left, top] = [Math.min(...boxes.map((box) => box.left)), Math.min(...boxes.map((box) => box.top))];
  const [right, bottom] = [
    Math.max(...boxes.map((box) => box.right)),
    Math.max(...boxes.map((box) => box.bottom)),
  ];
  const canvas = document.createElement("canvas");
  canvas.width = Math.round((right - left) * ratio.peek());
  canvas.height = Math.round((bottom - top) * ratio.peek());
  const context = canvas.getContext("2d")!;
  context.scale(ratio.peek(), ratio.peek());
  context.fillStyle = getComputedStyle(stages[0].frame).backgroundColor;
  context.fillRect(0, 0, right - left, bottom - top);
  stages.forEach(({ frame, draw }, k) => {
    draw();
    const { clientWidth, clientHeight } = frame;
    for (const layer of frame.querySelectorAll("canvas")) {
      context.drawImage(layer, boxes[k].left - left, boxes[k].top - top, clientWidth, clientHeight);
    }
  });
  return canvas;
}
