import { expect, test } from "vitest";
import { wants, withOption } from "./wants";

test("algorithms are asked for what they know", () => {
  expect(wants({ name: "random-incremental", takes: "points" })).toEqual(["seed"]);
  expect(wants({ name: "fortune", takes: "points" })).toEqual([]);
  expect(wants({ name: "edge-flip", takes: "triangulation" })).toEqual([]);
  expect(wants({ name: "sweep", takes: "domain" })).toEqual(["domain"]);
  expect(wants({ name: "algorithm-b", takes: "data" })).toEqual(["dataPerTriangle"]);
});

test("an option without a value is none", () => {
  expect(withOption({ seed: 1 }, "minAngle", 20)).toEqual({ seed: 1, minAngle: 20 });
  expect(withOption({ seed: 1, minAngle: 20 }, "minAngle", Number.NaN)).toEqual({ seed: 1 });
  expect(withOption({ domain: "hull" }, "domain", "")).toEqual({});
});
