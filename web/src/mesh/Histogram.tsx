// How many triangles have which value. The bars have the colours of the triangles, so they are the legend, too; a click
// on one shows its triangles.

import { signal } from "@preact/signals";
import { type Measure, measures } from "../engine/protocol";
import { scale } from "../stage/scale";
import { drawing } from "../state/drawing";
import { made, measure, measured } from "../state/mesh";
import { count as whole, words } from "../words";
import { type Axis, along, goodness, valueAt } from "./axis";
import { axis, counts, highlight, isColoured } from "./colours";
import { Check, Choice } from "./fields";
import { written } from "./writing";

const [WIDTH, HEIGHT] = [320, 120];

/** The least height of a bar that counts anything, so that it can be seen. */
const LEAST = 2;

/** Where along the axis something is written. */
const TICKS = [0, 0.25, 0.5, 0.75, 1];

/** The bar that Tab goes to; arrows go from there. */
const reached = signal(0);

export function Histogram() {
  const say = words.value.mesh;
  const offered = measures.filter((each) => each !== "region" || (drawing.value?.about.regions ?? 0) > 0);
  return (
    <section aria-labelledby="mesh-histogram">
      <h3 id="mesh-histogram" class="hidden">
        {say.histogram}
      </h3>
      <Choice
        label={say.measure}
        hint={say.measureHints[measure.value]}
        value={measure.value}
        options={offered.map((each) => [each, say.measures[each]] as const)}
        onChange={(each: Measure) => {
          measure.value = each;
        }}
      />
      {axis.value && measured.value && <Chart along={axis.value} of={measured.value.measure} />}
      <Shown />
      <Check
        label={say.colour}
        isOn={isColoured.value}
        onChange={(isOn) => {
          isColoured.value = isOn;
        }}
      />
    </section>
  );
}

/** What a click on a bar shows, and how to see everything again. */
function Shown() {
  const say = words.value.mesh;
  const meant = highlight.value;
  const count = meant !== null && meant !== "unmet" ? counts.value[meant.bar] : null;
  return (
    <p class="mesh-shown quiet mesh-small" aria-live="polite">
      {count === null ? (
        say.histogramHint
      ) : (
        <>
          {say.highlighted(whole(count))}
          <button
            type="button"
            onClick={() => {
              highlight.value = null;
            }}
          >
            {say.showAll}
          </button>
        </>
      )}
    </p>
  );
}

function Chart({ along: scaleOf, of }: { along: Axis; of: Measure }) {
  const say = words.value.mesh;
  const all = counts.value;
  const most = Math.max(...all, 1);
  return (
    <figure class="mesh-chart">
      {/* biome-ignore lint/a11y/useSemanticElements: fieldsets cannot be drawn into */}
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="group" aria-label={say.histogram} onKeyDown={walk}>
        {all.map((count, bar) => (
          <Bar key={bar} along={scaleOf} of={of} bar={bar} count={count} most={most} />
        ))}
        <Bound along={scaleOf} of={of} />
      </svg>
      <div class="mesh-ticks figure" aria-hidden="true">
        {TICKS.map((part) => (
          <span key={part}>{written(of, valueAt(scaleOf, part))}</span>
        ))}
      </div>
    </figure>
  );
}

interface BarProps {
  along: Axis;
  of: Measure;
  bar: number;
  count: number;
  most: number;
}

function Bar({ along: scaleOf, of, bar, count, most }: BarProps) {
  const { bars } = scaleOf;
  const width = WIDTH / bars;
  const height = count > 0 ? Math.max((count / most) * (HEIGHT - 8), LEAST) : 0;
  const ends = [bar / bars, (bar + 1) / bars].map((part) => valueAt(scaleOf, part));
  const middle = valueAt(scaleOf, (bar + 0.5) / bars);
  const meant = highlight.value;
  const isMeant = meant !== null && meant !== "unmet" && meant.bar === bar;
  const label = words.value.mesh.bar(written(of, ends[0]), written(of, ends[1]), whole(count));
  const toggle = () => {
    reached.value = bar;
    highlight.value = isMeant ? null : { bar };
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: buttons cannot be drawn
    <g
      role="button"
      aria-pressed={isMeant}
      aria-label={label}
      tabIndex={bar === Math.min(reached.value, bars - 1) ? 0 : -1}
      class={`mesh-bar${meant !== null && !isMeant ? " faint" : ""}`}
      onClick={toggle}
      onKeyDown={(event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        event.stopPropagation();
        toggle();
      }}
    >
      <title>{label}</title>
      <rect class="reach" x={bar * width} y="0" width={width} height={HEIGHT} />
      <rect
        class="count"
        x={bar * width + width * 0.06}
        y={HEIGHT - height}
        width={width * 0.88}
        height={height}
        fill={isColoured.value ? scale(goodness(scaleOf, middle)) : undefined}
      />
    </g>
  );
}

/** Arrows go from bar to bar. */
function walk(event: KeyboardEvent): void {
  const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  const { target, currentTarget } = event;
  if (by === undefined || !(target instanceof Element) || !(currentTarget instanceof Element)) return;
  event.preventDefault();
  const bars = [...currentTarget.querySelectorAll<SVGElement>("[role=button]")];
  const next = bars.indexOf(target as SVGElement) + by;
  if (!bars[next]) return;
  reached.value = next;
  bars[next].focus();
}

/** What was asked for, as a line. */
function Bound({ along: scaleOf, of }: { along: Axis; of: Measure }) {
  const bound = boundOf(of);
  if (!bound || bound < scaleOf.low || bound > scaleOf.high) return null;
  const x = along(scaleOf, bound) * WIDTH;
  const isLeft = x > WIDTH * 0.6;
  return (
    <g class="mesh-bound">
      <line x1={x} y1="0" x2={x} y2={HEIGHT} />
      <text x={x + (isLeft ? -5 : 5)} y="11" text-anchor={isLeft ? "end" : "start"}>
        {words.value.mesh.bound(written(of, bound))}
      </text>
    </g>
  );
}

function boundOf(of: Measure): number | undefined {
  const asked = made.value?.kind === "refine" ? made.value.options : {};
  return { minAngle: asked.minAngle, longestEdge: asked.maxEdge, area: asked.maxArea }[of as string];
}
