// Breakpoints stop where a plain search through all steps of a run says that they should, in both directions; through
// the module, in Node.

import { existsSync, readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import type { Condition, Run, Step } from "../../src/engine/protocol";

const file = new URL("../../src/wasm/delone_bg.wasm", import.meta.url);
const isBuilt = existsSync(file);

type Engine = typeof import("../../src/engine/players") & typeof import("../../src/engine/drawings");
let engine: Engine;

beforeAll(async () => {
  if (!isBuilt) return;
  const { initSync } = await import("../../src/wasm/delone.js");
  initSync({ module: readFileSync(file) });
  engine = { ...(await import("../../src/engine/players")), ...(await import("../../src/engine/drawings")) };
});

/** Runs an algorithm on a preset; returns the run and all of its steps, that at position 1 first. */
function played(algorithm: string, name: string, count: number): [Run, Step[]] {
  engine.drawings.make({ source: { kind: "preset", name, count, seed: 1 }, edits: [] });
  const run = engine.players.run(0, algorithm, { seed: 1 });
  const steps = Array.from({ length: run.length }, (_, i) => engine.players.tell(0, i + 1, "en").step!);
  return [run, steps];
}

/** Whether a condition is met by the step at an index, told from the steps alone. */
type Plain = (steps: Step[], i: number) => boolean;

const event = ({ kind, event }: Step) => (event as Record<string, Record<string, unknown>>)[kind] ?? {};

/** The vertices that a step names, and the edges, as text. */
const corners = (step: Step): unknown[] => {
  const { vertex, point, by, edge, segment, line, ray, triangle, item, from, to, datum } = event(step);
  const flipped = step.kind === "edge-flipped" || step.kind === "datum-reassigned" ? [from, to] : [];
  const waiting = Object.values((item ?? {}) as object);
  return [vertex, point, by, datum, edge, segment, line, ray, triangle, ...flipped, ...waiting].flat();
};

const isEdge = (pair: unknown, [a, b]: number[]) =>
  Array.isArray(pair) && pair.length === 2 && pair.includes(a) && pair.includes(b);

const edges = (step: Step): unknown[] => {
  const { edge, segment, line, ray, item, from, to } = event(step);
  const flipped = step.kind === "edge-flipped" ? [from, to] : [];
  return [edge, segment, line, ray, (item as { edge?: unknown } | undefined)?.edge, ...flipped];
};

/** The edge that is made last but a few. */
const anEdge = (steps: Step[]): [number, number] => {
  const made = steps.filter(({ kind }) => kind === "edge-created");
  return event(made[Math.floor(0.7 * made.length)]).edge as [number, number];
};

const conflicts = (steps: Step[], i: number): number | undefined => {
  const told = steps.slice(0, i + 1).findLast(({ kind }) => kind === "conflicts-counted");
  return told && (event(told).conflicts as number);
};

const cases: [string, Condition, Plain][] = [
  ["a flip", { kind: "flip" }, (steps, i) => steps[i].kind === "edge-flipped"],
  ["the end of a stage", { kind: "stage" }, (steps, i) => steps[i].kind === "stage-ended"],
  ["a kind of events", { kind: "circle-tested" }, (steps, i) => steps[i].kind === "circle-tested"],
  ["line 3", { line: 3 }, (steps, i) => steps[i].line === 3 && steps[i - 1]?.line !== 3],
  ["line 1", { line: 1 }, (steps, i) => steps[i].line === 1 && steps[i - 1]?.line !== 1],
  ["vertex 7", { vertex: 7 }, (steps, i) => corners(steps[i]).includes(7)],
  [
    "few conflicts",
    { curve: "conflicts", below: 14 },
    (steps, i) => {
      const [before, now] = [conflicts(steps, i - 1), conflicts(steps, i)];
      return now !== undefined && now < 14 && (before === undefined || before >= 14);
    },
  ],
];

describe.skipIf(!isBuilt)("the module is built: stops are those of a plain search", () => {
  const algorithms: [string, string][] = [
    ["flip-list", "uniform"],
    ["greedy-flips", "uniform"],
    ["random-incremental", "uniform"],
    ["sweep", "thesis"],
    ["sweep-circle", "uniform"],
    ["fortune", "uniform"],
    ["refinement", "thesis"],
    ["algorithm-a", "uniform"],
  ];
  test.each(algorithms)("%s", (algorithm, preset) => {
    const [run, steps] = played(algorithm, preset, 14);
    const edge = anEdge(steps);
    const named: Plain = (all, i) => edges(all[i]).some((pair) => isEdge(pair, edge));
    for (const [name, condition, isMet] of [...cases, ["an edge", { edge }, named] as const]) {
      const expected = steps.flatMap((_, i) => (isMet(steps, i) ? [i + 1] : []));
      const forwards: number[] = [];
      const backwards: number[] = [];
      const next = (from: number, isBack: boolean) =>
        engine.players.stop(0, [condition], from, isBack)?.position;
      for (let at = next(0, false); at !== undefined; at = next(at, false)) forwards.push(at);
      for (let at = next(run.length + 1, true); at !== undefined; at = next(at, true)) backwards.unshift(at);
      expect(forwards, `${name}, forwards`).toEqual(expected);
      expect(backwards, `${name}, backwards`).toEqual(expected);
      expect(engine.players.stops(0, [condition], 1e6), `${name}, all`).toEqual(expected);
    }
  });

  test("of several conditions the nearest stops, the first of equals", () => {
    const [run] = played("flip-list", "uniform", 14);
    const all: Condition[] = [{ line: 4 }, { kind: "flip" }, { vertex: 7 }];
    for (let from = 0; from <= run.length; from++) {
      const single = all.map((each) => engine.players.stop(0, [each], from, false)?.position ?? Infinity);
      const nearest = Math.min(...single);
      const expected =
        nearest === Infinity ? undefined : { position: nearest, which: single.indexOf(nearest) };
      expect(engine.players.stop(0, all, from, false)).toEqual(expected);
    }
  });

  test("each condition is met somewhere", () => {
    const [, steps] = played("flip-list", "uniform", 14);
    const usual = cases.filter(([, condition]) => !("edge" in condition || "kind" in condition));
    for (const [name, , isMet] of usual)
      expect(
        steps.some((_, i) => isMet(steps, i)),
        name,
      ).toBe(true);
    expect(engine.players.stops(0, [{ edge: anEdge(steps) }], 1e6).length).toBeGreaterThan(1);
  });
});

test.skipIf(isBuilt)(
  "the module is not built: stops are not tested (cargo run -p delone-web-build)",
  () => {},
);
