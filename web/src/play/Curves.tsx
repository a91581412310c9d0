// How numbers change over the run, one small chart each; a click goes to that step.

import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { type CurveName, curves, type Run } from "../engine/protocol";
import { tell } from "../state/notices";
import { askRun, frame, position, run, shownRun } from "../state/play";
import { number, words } from "../words";
import { extent, pathOf, type Samples, valueAt } from "./chart";
import { go } from "./keys";

/** Pairs of a curve: as many as the chart has pixels, about. */
const PAIRS = 800;

/** The size of a chart in its own units. */
const [WIDTH, HEIGHT] = [300, 44];

const loaded = signal<{ of: Run | null; curves: [CurveName, Samples][] }>({ of: null, curves: [] });

async function load(of: Run): Promise<void> {
  const found: [CurveName, Samples][] = [];
  try {
    for (const name of curves) {
      const samples = await askRun(({ players }, slot) => players.curve(slot, name, PAIRS));
      if (run.peek() !== of) return;
      if (samples.length > 0) found.push([name, samples]);
    }
    loaded.value = { of, curves: found };
  } catch (error) {
    tell(error);
  }
}

export function Curves() {
  const of = run.value;
  useEffect(() => {
    if (of && loaded.peek().of !== of) void load(of);
  }, [of]);
  const say = words.value.play.curves;
  // Those of the run before stay until there are others.
  const there = shownRun.value ? loaded.value : null;
  return (
    <details class="fold" open>
      <summary>{say.heading}</summary>
      <div class="charts" title={say.hint}>
        {there?.curves.map(([name, samples]) => (
          <Chart key={name} name={name} samples={samples} length={there.of?.length ?? 0} />
        ))}
        {there?.of && there.curves.length === 0 && <p class="quiet">{say.none}</p>}
      </div>
    </details>
  );
}

function Chart({ name, samples, length }: { name: CurveName; samples: Samples; length: number }) {
  const say = words.value.play.curves;
  const title = say.names[name];
  const [low, high] = extent(samples);
  const value = valueAt(samples, frame.value?.position ?? 0);
  const here = value === undefined ? "–" : told(value);
  const x = (position.value / Math.max(1, length)) * WIDTH;
  const seekTo = (event: PointerEvent & { currentTarget: SVGSVGElement }) => {
    const box = event.currentTarget.getBoundingClientRect();
    go(((event.clientX - box.left) / box.width) * length);
  };
  return (
    <figure class="chart">
      <figcaption>
        {title} <b class="figure">{here}</b>
      </figcaption>
      <svg
        role="img"
        aria-label={say.said(title, here, told(low), told(high))}
        viewBox={`0 -2 ${WIDTH} ${HEIGHT + 4}`}
        preserveAspectRatio="none"
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          seekTo(event);
        }}
        onPointerMove={(event) => event.buttons === 1 && seekTo(event)}
      >
        <path class="chart-line" d={pathOf(samples, length, WIDTH, HEIGHT)} />
        <line class="chart-here" x1={x} x2={x} y1={-2} y2={HEIGHT + 2} />
      </svg>
      <span class="chart-high figure">{told(high)}</span>
      <span class="chart-low figure">{told(low)}</span>
    </figure>
  );
}

// A number beside a chart: short.
const told = (value: number): string => number(value, Math.abs(value) < 1000 ? 3 : 4);
