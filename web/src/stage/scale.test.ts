// The colours of values.

import { expect, test } from "vitest";
import { ramp, scale, shade } from "./scale";

test("lightness goes up evenly", () => {
  const lights = Array.from({ length: 21 }, (_, k) => lightness(shade(k / 20)));
  const steps = lights.slice(1).map((light, k) => light - lights[k]);
  expect(Math.min(...steps)).toBeGreaterThan(1.8);
  expect(Math.max(...steps)).toBeLessThan(4.2);
});

test("no colour is cut off by what a screen can show", () => {
  for (let k = 0; k <= 20; k++) {
    const sum = shade(k / 20).filter((part) => part === 0 || part === 255).length;
    expect(sum).toBe(0);
  }
});

test("what is no value has a colour, too", () => {
  expect(scale(Number.NaN)).toBe(scale(0));
  expect(scale(-3)).toBe(scale(0));
  expect(scale(7)).toBe(scale(1));
  expect([...ramp(3).slice(4, 8)]).toEqual([...shade(0.5), 255]);
});

/** L* of CIELAB. */
function lightness(rgb: readonly number[]): number {
  const [red, green, blue] = rgb.map((part) => {
    const light = part / 255;
    return light <= 0.04045 ? light / 12.92 : ((light + 0.055) / 1.055) ** 2.4;
  });
  return 116 * Math.cbrt(0.2126 * red + 0.7152 * green + 0.0722 * blue) - 16;
}
