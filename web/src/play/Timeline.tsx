// The slider, over a strip that shows what happens where.

import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { paint } from "../stage/paint";
import { position, seek, shownRun } from "../state/play";
import { theme } from "../state/settings";
import { count, words } from "../words";
import { drawStrip, type Strip } from "./drawStrip";
import { moments, ticks } from "./moments";
import { pixelOf, positionAt } from "./strip";

export function Timeline() {
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const width = useSignal(0);
  const hovered = useSignal<number | null>(null);
  const length = useComputed(() => shownRun.value?.length ?? 0);

  useEffect(() => {
    const [element, picture] = [box.current!, canvas.current!];
    const observer = new ResizeObserver(() => {
      width.value = element.clientWidth;
    });
    observer.observe(element);
    const stop = paint(() => draw(picture, width.value));
    return () => {
      observer.disconnect();
      stop();
    };
  }, [width]);

  const say = words.value.play;
  const hint = hovered.value;
  const wide = width.value;
  return (
    <div
      class="timeline"
      ref={box}
      onPointerMove={({ offsetX }) => {
        hovered.value = positionAt(offsetX, length.value, wide);
      }}
      onPointerLeave={() => {
        hovered.value = null;
      }}
    >
      <div aria-hidden="true">
        <canvas ref={canvas} />
      </div>
      <input
        type="range"
        aria-label={say.position}
        aria-valuetext={say.of(count(position.value), count(length.value))}
        min={0}
        max={length.value}
        value={position.value}
        onInput={(event) => seek(event.currentTarget.valueAsNumber)}
      />
      {hint !== null && length.value > 0 && (
        <span
          class="timeline-hint figure"
          aria-hidden="true"
          style={{ left: `${Math.max(24, Math.min(wide - 24, pixelOf(hint, length.value, wide)))}px` }}
        >
          {count(hint)}
        </span>
      )}
    </div>
  );
}

function draw(canvas: HTMLCanvasElement, width: number): void {
  void theme.value;
  const height = canvas.clientHeight;
  const ratio = devicePixelRatio;
  const size = { width: Math.round(width * ratio), height: Math.round(height * ratio) };
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawStrip(context, width, height, {
    length: shownRun.value?.length ?? 0,
    position: position.value,
    moments: moments.value,
    ticks: ticks.value,
    colours: readColours(canvas),
  });
}

function readColours(canvas: HTMLCanvasElement): Strip["colours"] {
  const style = getComputedStyle(canvas);
  const colour = (name: string) => style.getPropertyValue(name).trim();
  return {
    insertion: colour("--stage-good"),
    flip: colour("--accent"),
    stage: colour("--stage-front"),
    breakpoint: colour("--error"),
    played: colour("--played"),
  };
}
