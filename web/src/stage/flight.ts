// The way from one view to another: short, and the eye can follow.

import type { Camera, Size } from "./camera";

/** Milliseconds that a flight takes. */
const DURATION = 240;

/** Views that are so many times larger, or so many views apart, have nothing to do with each other. */
const FACTOR = 1000;
const VIEWS = 3;

/** Returns whether the eye could follow. */
export function canFollow(from: Camera, to: Camera, { width, height }: Size): boolean {
  const factor = from.scale / to.scale;
  const scale = Math.min(from.scale, to.scale);
  const way = Math.max(Math.abs(from.x - to.x), Math.abs(from.y - to.y)) * scale;
  return factor < FACTOR && factor > 1 / FACTOR && way < VIEWS * Math.max(width, height);
}

/** Returns the view after a part of the way: it grows evenly, and the place where both views agree stays where it is. */
export function between(from: Camera, to: Camera, part: number): Camera {
  if (part >= 1) return to;
  const factor = to.scale / from.scale;
  const grown = factor ** part;
  // How far the middle is by then. Nearly the same scale: the formula tends to `part`.
  const moved = Math.abs(factor - 1) < 1e-6 ? part : (1 - 1 / grown) / (1 - 1 / factor);
  return {
    x: from.x + moved * (to.x - from.x),
    y: from.y + moved * (to.y - from.y),
    scale: from.scale * grown,
  };
}

/** Shows the views on the way, and null at the end. Returns how to stop. */
export function fly(from: Camera, to: Camera, show: (camera: Camera | null) => void): () => void {
  const since = performance.now();
  let request = 0;
  const step = () => {
    const part = Math.min((performance.now() - since) / DURATION, 1);
    show(part < 1 ? between(from, to, 1 - (1 - part) ** 3) : null);
    if (part < 1) request = requestAnimationFrame(step);
  };
  step();
  return () => cancelAnimationFrame(request);
}
