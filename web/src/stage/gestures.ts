// Pointers, wheels and keys on the stage: first the tool in hand, then the view.

import type { Signal } from "@preact/signals";
import { type Camera, pan, type Size, toPlane, zoom } from "./camera";
import { type Place, pointer, type Tool, tool } from "./tool";

/** How far, in pixels, a hand trembles while it clicks. */
const TREMBLE = 4;

/** How far a turn of the wheel zooms. */
const WHEEL = 0.0015;

/** Listens on an element until the returned function is called. */
export function listen(element: HTMLElement, camera: Signal<Camera>, size: Signal<Size>): () => void {
  const held = new Map<number, { x: number; y: number }>();
  let busy: Tool | null = null;
  let clicked: { x: number; y: number } | null = null;

  const place = (event: PointerEvent): Place => {
    const [x, y] = toPlane(camera.value, size.value, event.offsetX, event.offsetY);
    return { x, y, pixel: 1 / camera.value.scale, event };
  };
  const down = (event: PointerEvent) => {
    element.setPointerCapture(event.pointerId);
    held.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (held.size > 1) {
      busy?.cancel?.();
      [busy, clicked] = [null, null];
    } else if (event.button === 0 && tool.value) {
      // While somebody draws, the view is no longer fitted to what is drawn.
      camera.value = { ...camera.value };
      if (tool.value.down(place(event))) busy = tool.value;
      else clicked = { x: event.offsetX, y: event.offsetY };
    }
  };
  const move = (event: PointerEvent) => {
    const { x, y, pixel } = place(event);
    pointer.value = { x, y, pixel };
    const before = held.get(event.pointerId);
    if (clicked && Math.hypot(event.offsetX - clicked.x, event.offsetY - clicked.y) > TREMBLE) clicked = null;
    if (busy) busy.move?.(place(event));
    else if (clicked) return;
    else if (before) drag(event, before);
  };
  const drag = (event: PointerEvent, before: { x: number; y: number }) => {
    const [dx, dy] = [event.offsetX - before.x, event.offsetY - before.y];
    const other = [...held].find(([id]) => id !== event.pointerId)?.[1];
    held.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    let next = pan(camera.value, dx / held.size, dy / held.size);
    if (other) {
      const [was, is] = [
        Math.hypot(before.x - other.x, before.y - other.y),
        Math.hypot(event.offsetX - other.x, event.offsetY - other.y),
      ];
      const [mx, my] = [(event.offsetX + other.x) / 2, (event.offsetY + other.y) / 2];
      if (was > 0 && is > 0) next = zoom(next, size.value, is / was, mx, my);
    }
    camera.value = next;
  };
  const up = (event: PointerEvent) => {
    held.delete(event.pointerId);
    busy?.up?.(place(event));
    if (clicked) tool.value?.click?.(place(event));
    [busy, clicked] = [null, null];
  };
  const lost = (event: PointerEvent) => {
    held.delete(event.pointerId);
    busy?.cancel?.();
    [busy, clicked] = [null, null];
  };
  const leave = () => {
    pointer.value = null;
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const factor = Math.exp(-WHEEL * lines * event.deltaY);
    camera.value = zoom(camera.value, size.value, factor, event.offsetX, event.offsetY);
  };

  const abort = new AbortController();
  const options = { signal: abort.signal };
  element.addEventListener("pointerdown", down, options);
  element.addEventListener("pointermove", move, options);
  element.addEventListener("pointerup", up, options);
  element.addEventListener("pointercancel", lost, options);
  element.addEventListener("pointerleave", leave, options);
  element.addEventListener("wheel", wheel, { ...options, passive: false });
  return () => abort.abort();
}
