import { expect, test } from "vitest";
import { advance, agreement, fullTime, places, type Totals, withRacer } from "./racing";

const totals = (steps: number, predicates: number, milliseconds: number | null): Totals => ({
  steps,
  predicates,
  milliseconds,
});
const all = [totals(100, 30, 2), totals(50, 40, null), totals(100, 10, 1)];

test("the clock goes until the slowest is there", () => {
  expect(fullTime(all, "steps")).toBe(100);
  expect(fullTime(all, "predicates")).toBe(40);
  expect(fullTime(all, "milliseconds")).toBe(2);
  expect(fullTime([], "steps")).toBe(0);
});

test("a race takes as long as it is asked to, whatever the unit", () => {
  let amount = 0;
  for (let i = 0; i < 10; i++) amount = advance(amount, 40, 0.5, 5);
  expect(amount).toBeCloseTo(40);
  expect(advance(39, 40, 10, 5)).toBe(40);
  expect(advance(0, 0, 1, 5)).toBe(0);
});

test("who needs least is first, and equals share a place", () => {
  expect(places(all, "steps")).toEqual([2, 1, 2]);
  expect(places(all, "predicates")).toEqual([2, 3, 1]);
  expect(places(all, "milliseconds")).toEqual([2, 3, 1]);
});

test("nobody races against itself", () => {
  expect(withRacer(["a", "b", "c"], 0, "d")).toEqual(["d", "b", "c"]);
  expect(withRacer(["a", "b", "c"], 0, "c")).toEqual(["c", "b", "a"]);
  expect(withRacer(["a", "b", "c"], 1, "b")).toEqual(["a", "b", "c"]);
});

test("who differs by design is named, but only if all others agree", () => {
  const all = [
    { name: "flip-list", delaunay: true, takes: "triangulation" },
    { name: "fortune", delaunay: true, takes: "points" },
    { name: "printed-sweep", delaunay: false, takes: "domain" },
  ] as const;
  const run = (algorithm: string, hash: string) => ({ algorithm, hash });
  const [list, fortune, printed] = [run("flip-list", "a"), run("fortune", "a"), run("printed-sweep", "b")];
  expect(agreement([list, fortune], [...all])).toEqual({ agree: true, byDesign: [] });
  expect(agreement([list, fortune, printed], [...all])).toEqual({ agree: false, byDesign: [printed] });
  expect(agreement([list, run("fortune", "c"), printed], [...all])).toEqual({ agree: false, byDesign: [] });
});
