import { expect, test } from "vitest";
import { counting } from "./asked";

const all = { domain: "hull", minAngle: 20, maxEdge: 1, maxArea: 1, smoothing: 2, conforming: true } as const;

test("options that say nothing are left out", () => {
  expect(counting("refine", all)).toEqual(all);
  expect(counting("constrain", all)).toEqual({ domain: "hull" });
  expect(counting("triangulate", all)).toEqual({});
  expect(counting("refine", { ...all, thesis: true })).toEqual({
    domain: "hull",
    minAngle: 20,
    maxEdge: 1,
    thesis: true,
  });
});
