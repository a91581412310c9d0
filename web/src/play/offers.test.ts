import { expect, test } from "vitest";
import { conditionOf } from "./offers";

test("forms make conditions, or none if something is missing", () => {
  expect(conditionOf("flip", Number.NaN, Number.NaN)).toEqual({ kind: "flip" });
  expect(conditionOf("stage", Number.NaN, Number.NaN)).toEqual({ kind: "stage" });
  expect(conditionOf("vertex", 0, Number.NaN)).toEqual({ vertex: 0 });
  expect(conditionOf("vertex", 1.5, Number.NaN)).toBeNull();
  expect(conditionOf("vertex", -1, Number.NaN)).toBeNull();
  expect(conditionOf("edge", 3, 8)).toEqual({ edge: [3, 8] });
  expect(conditionOf("edge", 3, 3)).toBeNull();
  expect(conditionOf("edge", 3, Number.NaN)).toBeNull();
  expect(conditionOf("conflicts", 10, Number.NaN)).toEqual({ curve: "conflicts", below: 10 });
  expect(conditionOf("line", 0, Number.NaN)).toBeNull();
  expect(conditionOf("line", 7, Number.NaN)).toEqual({ line: 7 });
});
