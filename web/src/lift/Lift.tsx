// The lifted scene beside the stage: turned by hand or by keys, raised by a slider.

import { computed, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { CloseIcon } from "../app/icons";
import type { Mark } from "../engine/protocol";
import { circumcircle } from "../see/circles";
import { lastTest } from "../see/circleTests";
import { illegalEdges } from "../see/quads";
import { linksOf, shown } from "../see/shown";
import { turn } from "../see/turn";
import { boxOf, type Size } from "../stage/camera";
import { paint } from "../stage/paint";
import { readPalette } from "../stage/palette";
import { drawing } from "../state/drawing";
import { mode } from "../state/mode";
import { frame } from "../state/play";
import { isLifted } from "../state/see";
import { theme, wantsLessMotion } from "../state/settings";
import { number, words } from "../words";
import { drawLifted, type Upon } from "./draw";
import { above, aside, between, Lift as Lifted, type Posture, turned } from "./project";
import "./lift.css";

/** Triangles beyond which a painter is too slow. */
const MOST = 20_000;

/** How long the scene takes to rise, in milliseconds. */
const RISE = 1200;

/** Radians a pixel, and a key. */
const [BY_HAND, BY_KEY] = [0.008, 0.1];

/** Pixels left free around the scene. */
const MARGIN = 16;

const posture = signal<Posture>(above);

const box = computed(() => boxOf(drawing.value?.points ?? new Float64Array()));

const isTooMuch = computed(() => (shown.value?.triangles.length ?? 0) > 3 * MOST);

/** What is drawn upon the facets: only what belongs to a run. */
const upon = computed<Upon>(() => {
  const illegal = illegalEdges.value ?? [];
  const now = frame.value;
  if (mode.value === "mesh" || !now) return { illegal, triangles: [], test: null };
  const marks = now.step?.marks ?? [];
  const areas = marks.filter((mark): mark is Mark & { shape: "triangle" } => mark.shape === "triangle");
  const test = lastTest(turn.value);
  const circle = test && circumcircle(now.points, test.triangle);
  return {
    illegal,
    triangles: areas.map(({ triangle, tone }) => ({ corners: triangle, colour: tone })),
    test: circle && { circle, ...test, colour: test.is_inside ? "bad" : "good" },
  };
});

export function Lift() {
  const say = words.value.see.lift;
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(rise, []);
  useEffect(() => show(canvas.current!), []);
  return (
    <section class="lift" aria-label={say.show}>
      <div
        class="lift-view"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it is turned by keys
        tabIndex={0}
        role="application"
        aria-label={say.label}
        onKeyDown={press}
        onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
        onPointerMove={drag}
      >
        <canvas ref={canvas} />
      </div>
      <button type="button" class="lift-close" aria-label={say.close} title={say.close} onClick={close}>
        <CloseIcon />
      </button>
      <div class="lift-foot">
        <label>
          <span class="quiet">{say.flat}</span>
          <input
            type="range"
            aria-label={say.height}
            min={0}
            max={1}
            step={0.01}
            value={posture.value.lift}
            onInput={(event) => {
              posture.value = { ...posture.value, lift: event.currentTarget.valueAsNumber };
            }}
          />
          <span class="quiet">{say.lifted}</span>
        </label>
        <output class="quiet">{verdict()}</output>
      </div>
    </section>
  );
}

/** Says whether the facets are those of a convex hull. */
function verdict(): string {
  const say = words.value.see.lift;
  const count = (shown.value?.triangles.length ?? 0) / 3;
  if (count === 0) return say.none;
  if (isTooMuch.value) return say.tooMany(number(MOST));
  if (!illegalEdges.value) return "";
  const bent = illegalEdges.value.length / 4;
  return bent === 0 ? say.convex : say.bent(bent);
}

function close(): void {
  isLifted.value = false;
  // The focus goes back to where the view was opened.
  document.querySelector<HTMLElement>(".see-lift")?.focus();
}

/** Raises the scene from what the stage shows. Returns how to stop that. */
function rise(): () => void {
  posture.value = wantsLessMotion() ? aside : above;
  let request = 0;
  let begin: number | undefined;
  const step = (now: number) => {
    begin ??= now;
    const share = Math.min(1, (now - begin) / RISE);
    posture.value = between(above, aside, share);
    if (share < 1) request = requestAnimationFrame(step);
  };
  if (!wantsLessMotion()) request = requestAnimationFrame(step);
  stop = () => cancelAnimationFrame(request);
  return stop;
}

/** Stops the scene from rising by itself: a hand has taken it. */
let stop = () => {};

function drag(event: PointerEvent): void {
  if (event.buttons === 0) return;
  stop();
  posture.value = turned(posture.value, event.movementX * BY_HAND, event.movementY * BY_HAND);
}

const keys: Record<string, [number, number]> = {
  ArrowLeft: [-BY_KEY, 0],
  ArrowRight: [BY_KEY, 0],
  ArrowUp: [0, BY_KEY],
  ArrowDown: [0, -BY_KEY],
};

function press(event: KeyboardEvent): void {
  const by = keys[event.key];
  if (!by && event.key !== "Home") return;
  // Elsewhere these keys step through the run.
  event.preventDefault();
  event.stopPropagation();
  stop();
  posture.value = by ? turned(posture.value, ...by) : { ...aside, lift: posture.value.lift };
}

/** Returns how far the points of the drawing reach from the axis. */
function reach(lift: Lifted, points: Float64Array): number {
  let most = 0;
  // Helpers that an algorithm lays around them would make them small.
  const drawn = Math.min(points.length, drawing.value?.points.length ?? 0);
  for (let i = 0; i < drawn; i += 2)
    most = Math.max(most, Math.hypot(...lift.relative(points[i], points[i + 1])));
  return most || 1;
}

/** Draws whenever something changes, until the returned function is called. */
function show(canvas: HTMLCanvasElement): () => void {
  const size = signal<Size>({ width: 1, height: 1 });
  const observer = new ResizeObserver(() => {
    size.value = { width: canvas.clientWidth, height: canvas.clientHeight };
  });
  observer.observe(canvas);
  const context = canvas.getContext("2d")!;
  const stopPaint = paint(() => {
    void theme.value;
    const { width, height } = size.value;
    const ratio = devicePixelRatio;
    Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const scene = shown.value;
    if (!scene || isTooMuch.value) return;
    const lift = new Lifted(box.value, posture.value);
    // However it is turned, it stays in view.
    const [across, tall] = [width - 2 * MARGIN, height - 2 * MARGIN];
    const scale = Math.max(0, Math.min(across / 2, tall / 1.7)) / reach(lift, scene.points);
    const at = (x: number, y: number): [number, number] => [width / 2 + x * scale, height / 2 - y * scale];
    drawLifted({ context, palette: readPalette(canvas), at }, scene, linksOf(scene), lift, upon.value);
  });
  return () => {
    observer.disconnect();
    stopPaint();
  };
}
