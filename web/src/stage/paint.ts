// Drawing when something that is drawn has changed, and at most once a frame.

import { effect } from "@preact/signals";

/** Draws now, and again in the next frame after a signal has changed that was read. Returns how to stop. */
export function paint(draw: () => void): () => void {
  let request = 0;
  let dispose = () => {};
  const run = () => {
    request = 0;
    dispose();
    let isDrawn = false;
    dispose = effect(() => {
      if (isDrawn) request ||= requestAnimationFrame(run);
      else draw();
      isDrawn = true;
    });
  };
  run();
  return () => {
    cancelAnimationFrame(request);
    dispose();
  };
}
