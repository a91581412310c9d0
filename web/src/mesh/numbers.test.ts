import { expect, test } from "vitest";
import { nice, readNumber } from "./numbers";

test("numbers are read with a point or a comma, and nothing else is one", () => {
  expect(["0.25", "0,25", " 1e-3 ", "-2", ".5", "3."].map(readNumber)).toEqual([
    0.25, 0.25, 0.001, -2, 0.5, 3,
  ]);
  for (const text of ["", "x", "1,2,3", "0x10", "1e999", "--1", "Infinity", "1 2"]) {
    expect(readNumber(text), text).toBeNull();
  }
});

test("sizes are rounded to what people like", () => {
  expect([0.0312, 0.97, 9.6, 1234, 3.4e-300].map(nice)).toEqual([0.03, 1, 10, 1000, 3e-300]);
  for (const odd of [0, -1, Number.NaN, Number.POSITIVE_INFINITY]) expect(nice(odd)).toBe(1);
});
