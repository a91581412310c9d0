// Pointers and wheels on the stage: first the tool in hand, then the view.

import { hold, toPlane, zoom } from "./camera";
import { clicked, type Place, pointer, type Tool, tool } from "./tool";
import type { View } from "./view";

/** How far a turn of the wheel zooms, and a double click. */
const WHEEL = 0.0015;
const DOUBLE = 2;

/** How far a pointer may move, in pixels, and it still was a click. */
const STILL = 5;

interface Pixel {
  x: number;
  y: number;
}

/** Listens on an element until the returned function is called. */
export function listen(element: HTMLElement, view: View): () => void {
  const gestures = new Gestures(element, view);
  const abort = new AbortController();
  const options = { signal: abort.signal };
  element.addEventListener("pointerdown", (event) => gestures.down(event), options);
  element.addEventListener("pointermove", (event) => gestures.move(event), options);
  element.addEventListener("pointerup", (event) => gestures.up(event), options);
  element.addEventListener("pointercancel", (event) => gestures.lost(event), options);
  element.addEventListener("pointerleave", () => gestures.leave(), options);
  element.addEventListener("dblclick", (event) => gestures.double(event), options);
  element.addEventListener("mousedown", letGo, options);
  element.addEventListener("wheel", (event) => gestures.wheel(event), { ...options, passive: false });
  return () => abort.abort();
}

/** The mouse takes the focus from where it is, but keys go on to mean what they mean on the page: Tab is the way here. */
function letGo(event: MouseEvent): void {
  event.preventDefault();
  const { activeElement } = document;
  if (activeElement instanceof HTMLElement && !activeElement.contains(event.currentTarget as Node)) {
    activeElement.blur();
  }
}

class Gestures {
  private readonly held = new Map<number, Pixel>();
  /** The tool that has the gesture. */
  private busy: Tool | null = null;
  /** The place of the plane that a single pointer holds. */
  private grabbed: [number, number] | null = null;
  /** Where a single pointer went down, as long as it may become a click. */
  private pressed: Pixel | null = null;

  constructor(
    private readonly element: HTMLElement,
    private readonly view: View,
  ) {}

  down(event: PointerEvent): void {
    this.element.setPointerCapture(event.pointerId);
    this.held.set(event.pointerId, pixelOf(event));
    this.grabbed = null;
    this.pressed = null;
    if (this.held.size > 1) this.cancel();
    else if (event.button === 0) {
      // While somebody draws, the view is no longer fitted to what is drawn.
      if (tool.value) this.view.set(this.view.now.peek());
      if (tool.value?.down(this.place(event))) this.busy = tool.value;
      else this.pressed = pixelOf(event);
    }
  }

  move(event: PointerEvent): void {
    const place = this.place(event);
    pointer.value = { x: place.x, y: place.y, pixel: place.pixel };
    const before = this.held.get(event.pointerId);
    if (this.busy) this.busy.move?.(place);
    else if (before) this.dragFrom(event, before);
  }

  up(event: PointerEvent): void {
    this.release(event);
    this.busy?.up?.(this.place(event));
    this.busy = null;
    if (this.pressed) this.click(this.place(event));
    this.pressed = null;
  }

  /** The tool in hand draws by clicks; without one, whoever listens is told. */
  private click(place: Place): void {
    if (tool.value) tool.value.click?.(place);
    else clicked.peek()?.(place);
  }

  lost(event: PointerEvent): void {
    this.release(event);
    this.pressed = null;
    this.cancel();
  }

  leave(): void {
    pointer.value = null;
  }

  double(event: MouseEvent): void {
    if (!tool.value) this.view.zoomBy(event.shiftKey ? 1 / DOUBLE : DOUBLE, [event.offsetX, event.offsetY]);
  }

  wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const factor = Math.exp(-WHEEL * lines * event.deltaY);
    const { now, size } = this.view;
    this.view.set(zoom(now.peek(), size.peek(), factor, event.offsetX, event.offsetY));
  }

  private place(event: PointerEvent): Place {
    const camera = this.view.now.peek();
    const [x, y] = toPlane(camera, this.view.size.peek(), event.offsetX, event.offsetY);
    return { x, y, pixel: 1 / camera.scale, event };
  }

  private dragFrom(event: PointerEvent, before: Pixel): void {
    // A hand is never quite still.
    if (this.pressed && gap(this.pressed, pixelOf(event)) <= STILL) return;
    this.pressed = null;
    this.drag(event, before);
  }

  private drag(event: PointerEvent, before: Pixel): void {
    const [camera, size] = [this.view.now.peek(), this.view.size.peek()];
    const at = pixelOf(event);
    this.held.set(event.pointerId, at);
    const other = [...this.held].find(([id]) => id !== event.pointerId)?.[1];
    if (other) this.pinch(before, at, other);
    else {
      // Not step by step: that would add up what each step is rounded by.
      this.grabbed ??= toPlane(camera, size, before.x, before.y);
      this.view.set(hold(camera, size, this.grabbed, at.x, at.y));
    }
  }

  /** Two fingers: the place between them stays between them. */
  private pinch(before: Pixel, at: Pixel, other: Pixel): void {
    const [camera, size] = [this.view.now.peek(), this.view.size.peek()];
    const [was, is] = [gap(before, other), gap(at, other)];
    const [middle, next] = [between(before, other), between(at, other)];
    const place = toPlane(camera, size, middle.x, middle.y);
    const moved = hold(camera, size, place, next.x, next.y);
    this.view.set(was > 0 && is > 0 ? zoom(moved, size, is / was, next.x, next.y) : moved);
  }

  private release(event: PointerEvent): void {
    this.held.delete(event.pointerId);
    this.grabbed = null;
  }

  private cancel(): void {
    this.busy?.cancel?.();
    this.busy = null;
  }
}

const pixelOf = (event: PointerEvent): Pixel => ({ x: event.offsetX, y: event.offsetY });
const gap = (a: Pixel, b: Pixel): number => Math.hypot(a.x - b.x, a.y - b.y);
const between = (a: Pixel, b: Pixel): Pixel => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
