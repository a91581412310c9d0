// What a stage looks at: the camera that somebody has moved, or all there is, or what lies on the way there.

import {
  batch,
  computed,
  effect,
  type ReadonlySignal,
  type Signal,
  signal,
  untracked,
} from "@preact/signals";
import { wantsLessMotion } from "../state/settings";
import { type Box, boxOf, type Camera, fit, type Size, zoom } from "./camera";
import { canFollow, fly } from "./flight";

export class View {
  readonly size = signal<Size>({ width: 1, height: 1 });
  private readonly flight = signal<Camera | null>(null);
  private readonly home: Signal<Box>;
  private stop = () => {};

  /** Where the stage looks now. */
  readonly now: ReadonlySignal<Camera> = computed(
    () => this.flight.value ?? this.camera.value ?? fit(this.home.value, this.size.value),
  );

  constructor(
    private readonly camera: Signal<Camera | null>,
    private readonly whole: ReadonlySignal<Float64Array>,
    private readonly source: ReadonlySignal<unknown> | undefined,
  ) {
    this.home = signal(boxOf(whole.peek()));
  }

  /** Looks at all of what there is whenever it is something else. Returns how to stop. */
  follow(): () => void {
    let before: unknown = this.source?.peek() ?? null;
    const dispose = effect(() => {
      const next = this.source ? this.source.value : this.whole.value;
      if (next === before) return;
      const isFirst = before === null;
      before = next;
      untracked(() => this.arrive(isFirst));
    });
    return () => {
      this.stop();
      dispose();
    };
  }

  /** Looks there at once: a hand moves the view. */
  set(camera: Camera): void {
    this.stop();
    this.flight.value = null;
    this.camera.value = camera;
  }

  /** Looks there, on a way that the eye can follow if there is one and it may; null: at all there is. */
  glide(to: Camera | null): void {
    const from = this.now.peek();
    this.stop();
    batch(() => {
      if (!to) this.home.value = boxOf(this.whole.peek());
      this.camera.value = to;
      // The flight hides the camera, which is at its goal at once.
      const isShown = !wantsLessMotion() && canFollow(from, this.goal, this.size.peek());
      this.flight.value = isShown ? from : null;
    });
    if (!this.flight.peek()) return;
    this.stop = fly(from, this.goal, (camera) => {
      this.flight.value = camera;
    });
  }

  /** Zooms by a factor around a pixel, or around the middle. */
  zoomBy(factor: number, pixel?: readonly [number, number]): void {
    const { width, height } = this.size.peek();
    const [px, py] = pixel ?? [width / 2, height / 2];
    this.glide(zoom(this.goal, this.size.peek(), factor, px, py));
  }

  /** Where the stage looks when it has arrived. */
  get goal(): Camera {
    return this.camera.peek() ?? fit(this.home.peek(), this.size.peek());
  }

  private arrive(isFirst: boolean): void {
    if (isFirst) this.home.value = boxOf(this.whole.peek());
    else if (this.source || this.camera.peek() === null) this.glide(null);
  }
}
