// The stage: a canvas for the scene, and one above it for what is said about it.

import { type ReadonlySignal, type Signal, signal, useSignalEffect } from "@preact/signals";
import { useEffect, useId, useMemo, useRef } from "preact/hooks";
import { language, theme } from "../state/settings";
import { words } from "../words";
import { attention } from "./attention";
import { Corner } from "./Corner";
import { type Camera, fit } from "./camera";
import { listen } from "./gestures";
import { press } from "./keys";
import { paint } from "./paint";
import { readPalette } from "./palette";
import { Pen } from "./pen";
import { shown } from "./picture";
import { makeRenderer } from "./renderer";
import type { StageScene } from "./scene";
import { isDark, ratio } from "./surroundings";
import { tool } from "./tool";
import { View } from "./view";
import { Zoom } from "./Zoom";
import "./stage.css";

/** Draws something over the scene; it is drawn again when a signal changes that it reads. */
export type Overlay = (pen: Pen) => void;

interface Props {
  scene: ReadonlySignal<StageScene>;
  overlays: ReadonlySignal<Overlay[]>;
  /** Which part of the plane is seen; may be shared by several stages. Null: all of `whole`. */
  camera: Signal<Camera | null>;
  /** The points that `fit` brings into view. */
  whole: ReadonlySignal<Float64Array>;
  /** Something else when something else is shown, which is then fitted; the view stays as long as it is the same. If
   * missing, that is whenever `whole` changes and nobody has moved the view. */
  source?: ReadonlySignal<unknown>;
  /** What the stage shows, in words, for those who do not see it. */
  description?: ReadonlySignal<string>;
}

export function Stage({ scene, overlays, camera, whole, source, description }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const below = useRef<HTMLDivElement>(null);
  const above = useRef<HTMLCanvasElement>(null);
  const keys = useId();
  const view = useMemo(() => new View(camera, whole, source), [camera, whole, source]);

  useEffect(() => watch(frame.current!, above.current!, view), [view]);
  useEffect(
    () =>
      draw({ frame: frame.current!, below: below.current!, above: above.current!, view, scene, overlays }),
    [scene, overlays, view],
  );

  useSignalEffect(() => attend(view));

  const say = words.value.stage;
  return (
    <div class="stage" ref={frame} lang={language.value}>
      <div
        class="stage-view"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: an application is interactive, by its keys
        tabIndex={0}
        role="application"
        aria-label={description?.value || say.label}
        aria-describedby={keys}
        onKeyDown={(event) => press(event, view)}
      >
        <div ref={below} />
        <canvas ref={above} style={{ cursor: tool.value?.cursor ?? "grab" }} />
      </div>
      <p id={keys} hidden>
        {say.keys}
      </p>
      <Zoom view={view} />
      <Corner camera={view.now} />
    </div>
  );
}

/** Looks where somebody asks to look. */
function attend(view: View): void {
  if (!attention.value) return;
  view.glide(fit(attention.value, view.size.peek()));
  attention.value = null;
}

/** Follows sizes, sources and gestures until the returned function is called. */
function watch(frame: HTMLElement, hand: HTMLElement, view: View): () => void {
  const measure = () => {
    view.size.value = { width: frame.clientWidth, height: frame.clientHeight };
  };
  const observer = new ResizeObserver(measure);
  observer.observe(frame);
  measure();
  const stops = [listen(hand, view), view.follow(), () => observer.disconnect()];
  return () => {
    for (const stop of stops) stop();
  };
}

interface Parts extends Pick<Props, "scene" | "overlays"> {
  frame: HTMLElement;
  below: HTMLElement;
  above: HTMLCanvasElement;
  view: View;
}

/** Draws whenever something changes until the returned function is called. */
function draw({ frame, below, above, view, scene, overlays }: Parts): () => void {
  const stale = signal(0);
  const renderer = makeRenderer(below, () => {
    stale.value += 1;
  });
  const context = above.getContext("2d")!;
  const palette = () => {
    void [theme.value, isDark.value];
    return readPalette(frame);
  };
  const drawScene = () => {
    void stale.value;
    renderer.show(scene.value);
    renderer.draw(view.now.value, view.size.value, ratio.value, palette());
  };
  const drawOverlays = () => {
    const pen = new Pen(context, above, view.now.value, view.size.value, ratio.value, palette());
    for (const overlay of overlays.value) overlay(pen);
  };
  const mine = {
    frame,
    draw: () => {
      drawScene();
      drawOverlays();
    },
  };
  shown.add(mine);
  const stops = [paint(drawScene), paint(drawOverlays)];
  return () => {
    for (const stop of stops) stop();
    shown.delete(mine);
    renderer.dispose();
  };
}
