import { beforeEach, expect, test } from "vitest";
import {
  active,
  addBreakpoint,
  breakpoints,
  forgetLines,
  onLine,
  removeBreakpoint,
  switchBreakpoint,
  toggleLine,
} from "./breakpoints";

beforeEach(() => {
  breakpoints.value = [];
});

test("a breakpoint is there once, and switched on by whoever adds it again", () => {
  addBreakpoint({ vertex: 3 });
  addBreakpoint({ edge: [1, 2] });
  const [{ id }] = breakpoints.value;
  switchBreakpoint(id);
  expect(active.value).toHaveLength(1);
  addBreakpoint({ vertex: 3 });
  expect(breakpoints.value).toHaveLength(2);
  expect(active.value).toHaveLength(2);
  removeBreakpoint(id);
  expect(breakpoints.value.map(({ condition }) => condition)).toEqual([{ edge: [1, 2] }]);
});

test("lines are toggled, and forgotten with their algorithm", () => {
  toggleLine(4);
  addBreakpoint({ kind: "flip" });
  expect(onLine(4)).toBeDefined();
  expect(onLine(5)).toBeUndefined();
  toggleLine(4);
  expect(onLine(4)).toBeUndefined();
  toggleLine(2);
  forgetLines();
  expect(breakpoints.value.map(({ condition }) => condition)).toEqual([{ kind: "flip" }]);
});
