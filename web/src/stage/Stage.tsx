// The stage: a canvas for the scene, and one above it for what is said about it.

import { type ReadonlySignal, type Signal, useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { language, theme } from "../state/settings";
import { words } from "../words";
import { attention } from "./attention";
import { boxOf, type Camera, fit, type Size, zoom } from "./camera";
import { listen } from "./gestures";
import { paint } from "./paint";
import { readPalette } from "./palette";
import { Pen } from "./pen";
import { makeRenderer } from "./renderer";
import type { StageScene } from "./scene";
import { tool } from "./tool";
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
  /** What the stage shows, in words, for those who do not see it. */
  description?: ReadonlySignal<string>;
}

export function Stage({ scene, overlays, camera, whole, description }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const below = useRef<HTMLCanvasElement>(null);
  const above = useRef<HTMLCanvasElement>(null);
  const size = useSignal<Size>({ width: 1, height: 1 });
  const fitted = useComputed(() => fit(boxOf(whole.value), size.value));
  const view = useComputed(() => camera.value ?? fitted.value);

  useEffect(() => {
    const element = frame.current!;
    const observer = new ResizeObserver(() => {
      size.value = { width: element.clientWidth, height: element.clientHeight };
    });
    observer.observe(element);
    // Gestures change the view, whether or not it was the fitted one.
    const eye = {
      get value() {
        return view.value;
      },
      set value(next: Camera) {
        camera.value = next;
      },
    } as Signal<Camera>;
    const deaf = listen(above.current!, eye, size);
    return () => {
      observer.disconnect();
      deaf();
    };
  }, [camera, size, view]);

  useEffect(() => {
    const renderer = makeRenderer(below.current!);
    const context = above.current!.getContext("2d")!;
    const palette = () => {
      void theme.value;
      return readPalette(frame.current!);
    };
    const stops = [
      paint(() => {
        renderer.show(scene.value);
        renderer.draw(view.value, size.value, devicePixelRatio, palette());
      }),
      paint(() => {
        const pen = new Pen(context, above.current!, view.value, size.value, devicePixelRatio, palette());
        for (const overlay of overlays.value) overlay(pen);
      }),
    ];
    return () => {
      for (const stop of stops) stop();
      renderer.dispose();
    };
  }, [scene, overlays, size, view]);

  useSignalEffect(() => attend(camera, size.peek()));

  const zoomBy = (factor: number) => {
    const { width, height } = size.value;
    camera.value = zoom(view.value, size.value, factor, width / 2, height / 2);
  };
  const say = words.value.stage;
  return (
    <div class="stage" ref={frame} lang={language.value}>
      <div aria-hidden="true">
        <canvas ref={below} />
      </div>
      <canvas
        ref={above}
        style={{ cursor: tool.value?.cursor ?? "grab" }}
        role="img"
        aria-label={description?.value || say.label}
      />
      <div class="stage-zoom">
        <button type="button" aria-label={say.zoomIn} onClick={() => zoomBy(1.5)}>
          +
        </button>
        <button type="button" aria-label={say.zoomOut} onClick={() => zoomBy(1 / 1.5)}>
          −
        </button>
        <button
          type="button"
          onClick={() => {
            camera.value = null;
          }}
        >
          {say.fit}
        </button>
      </div>
    </div>
  );
}

/** Looks where somebody asks to look. */
function attend(camera: Signal<Camera | null>, size: Size): void {
  if (!attention.value) return;
  camera.value = fit(attention.value, size);
  attention.value = null;
}
