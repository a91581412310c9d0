// Lengths and places in words.

import { expect, test } from "vitest";
import { barFor, coordinateText, lengthText } from "./ruler";

test("the scale bar has a round length and a fair size", () => {
  for (let power = -305; power < 305; power += 0.37) {
    const { length, pixels } = barFor(10 ** power);
    expect(pixels).toBeGreaterThan(47);
    expect(pixels).toBeLessThanOrEqual(120.001);
    expect("125").toContain(length.toExponential()[0]);
    expect(length.toExponential()).toMatch(/^\de/);
  }
});

test.each([
  [0.002, "en", "0.002"],
  [0.5, "de", "0,5"],
  [20, "en", "20"],
  [50_000, "en", "50,000"],
  [5e-10, "en", "5·10⁻¹⁰"],
  [2e300, "de", "2·10³⁰⁰"],
])("the length %d in %s is %s", (length, language, text) => {
  expect(lengthText(length, language)).toBe(text);
});

test.each([
  [0.123456, 1e-3, "en", "0.123"],
  [500_033.3, 0.25, "en", "500,033.3"],
  [500_033.3, 40, "en", "500,033"],
  [500_033.25, 1e-9, "de", "500.033,250000000"],
  [0, 1e-3, "en", "0"],
  [-3e-301, 1e-303, "en", "-3.00·10⁻³⁰¹"],
  [1.5e300, 1e298, "en", "1.50·10³⁰⁰"],
])("%d with pixels of %d in %s is %s", (value, pixel, language, text) => {
  expect(coordinateText(value, pixel, language)).toBe(text);
});
