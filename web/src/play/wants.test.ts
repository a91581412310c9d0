import { expect, test } from "vitest";
import { isAboutAngles, usual, wants, withOption } from "./wants";

test("algorithms are asked for what they know", () => {
  expect(wants({ name: "random-incremental", takes: "points" })).toEqual(["seed"]);
  expect(wants({ name: "fortune", takes: "points" })).toEqual([]);
  expect(wants({ name: "edge-flip", takes: "triangulation" })).toEqual([]);
  expect(wants({ name: "refinement", takes: "domain" })).toEqual(["minAngle", "maxEdge", "domain"]);
  expect(wants({ name: "constrained", takes: "domain" })).toEqual(["domain"]);
  expect(wants({ name: "sweep", takes: "domain" })).toEqual(["domain"]);
  expect(wants({ name: "algorithm-b", takes: "data" })).toEqual(["dataPerTriangle"]);
});

test("what is usual depends on the algorithm", () => {
  const [thesis, refinement] = [{ name: "thesis" }, { name: "refinement" }];
  expect([usual(thesis, "minAngle"), usual(thesis, "maxEdge")]).toEqual(["20", "3"]);
  expect([usual(refinement, "minAngle"), usual(refinement, "maxEdge")]).toEqual(["20", undefined]);
  expect(isAboutAngles({ name: "refinement", takes: "domain" })).toBe(true);
  expect(isAboutAngles({ name: "sweep", takes: "domain" })).toBe(false);
});

test("an option without a value is none", () => {
  expect(withOption({ seed: 1 }, "minAngle", 20)).toEqual({ seed: 1, minAngle: 20 });
  expect(withOption({ seed: 1, minAngle: 20 }, "minAngle", Number.NaN)).toEqual({ seed: 1 });
  expect(withOption({ domain: "hull" }, "domain", "")).toEqual({});
});
