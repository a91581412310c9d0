import { expect, test } from "vitest";
import { advance, FASTEST, placeOf, rate, secondsBetween, speedAt } from "./pace";

test("the slider is logarithmic, and its end means as fast as it goes", () => {
  expect(speedAt(0)).toBe(0.5);
  expect(speedAt(FASTEST - 1)).toBe(10_000);
  expect(speedAt(FASTEST)).toBe(Number.POSITIVE_INFINITY);
  for (let place = 1; place <= FASTEST; place++) {
    expect(speedAt(place)).toBeGreaterThan(speedAt(place - 1));
    expect(Math.abs(placeOf(speedAt(place)) - place)).toBeLessThanOrEqual(1);
  }
});

test("as fast as it goes ends soon", () => {
  expect(rate(8, 10)).toBe(8);
  expect(rate(Number.POSITIVE_INFINITY, 10)).toBe(20_000);
  expect(5_000_000 / rate(Number.POSITIVE_INFINITY, 5_000_000)).toBe(4);
});

test("time passes forwards, and pauses are short", () => {
  expect(secondsBetween(1000, 1016)).toBeCloseTo(0.016);
  expect(secondsBetween(1000, 990)).toBe(0);
  expect(secondsBetween(1000, 9000)).toBe(0.25);
});

test("playing ends at the ends, and at stops on the way", () => {
  expect(advance(3, 4, 100, null)).toEqual({ to: 7, outcome: "on" });
  expect(advance(98, 4, 100, null)).toEqual({ to: 100, outcome: "end" });
  expect(advance(3, -4, 100, null)).toEqual({ to: 0, outcome: "end" });
  expect(advance(3, 4, 100, 5)).toEqual({ to: 5, outcome: "stopped" });
  expect(advance(3, 4, 100, 8)).toEqual({ to: 7, outcome: "on" });
  expect(advance(9, -4, 100, 5)).toEqual({ to: 5, outcome: "stopped" });
  expect(advance(9, -4, 100, 4)).toEqual({ to: 5, outcome: "on" });
  // The last step may be one that stops.
  expect(advance(98, 4, 100, 100)).toEqual({ to: 100, outcome: "stopped" });
});
