import { expect, test } from "vitest";
import { mix } from "./facets";
import { above, aside, between, Lift, lightOn, paintersOrder, turned } from "./project";

const box = { low: [0, 0], high: [4, 2] } as const;

test("from straight above the flat scene is the plane", () => {
  const lift = new Lift(box, above);
  expect(lift.relative(4, 2)).toEqual([1, 0.5]);
  const [x, y] = lift.see(0.3, -0.4, lift.height(0.3, -0.4));
  expect(x).toBeCloseTo(0.3);
  expect(y).toBeCloseTo(-0.4);
});

test("from the side the rim is higher than the middle, and what is in front is nearer", () => {
  const lift = new Lift(box, { azimuth: 0, tilt: 0.3, lift: 1 });
  const seen = (u: number, v: number) => lift.see(u, v, lift.height(u, v));
  expect(seen(1, 0)[1]).toBeGreaterThan(seen(0, 0)[1]);
  expect(seen(0, -1)[2]).toBeGreaterThan(seen(0, 1)[2]);
});

test("a point lies above the plane of a circle when it lies outside", () => {
  const lift = new Lift(box, aside);
  expect(lift.above(0.5, 0, 1)).toBeLessThan(0);
  expect(lift.above(1, 0, 1)).toBe(0);
  // The plane through the section: heights over the circle, less the height over its center, are linear.
  const [cu, cv, radius] = [0.2, 0.1, 0.5];
  const plane = (u: number, v: number) => lift.height(u, v) - lift.above(u - cu, v - cv, radius);
  expect(plane(0.9, 0.3) + plane(0.1, 0.7)).toBeCloseTo(2 * plane(0.5, 0.5));
  expect(plane(cu + radius, cv)).toBeCloseTo(lift.height(cu + radius, cv));
});

test("a painter begins with what is far away; equals keep their order", () => {
  const seen = Float64Array.of(0, 0, 5, 0, 0, 5, 0, 0, 5, 0, 0, -1, 0, 0, -1, 0, 0, -1);
  expect([...paintersOrder(Uint32Array.of(0, 1, 2, 3, 4, 5), seen)]).toEqual([1, 0]);
  expect([...paintersOrder(Uint32Array.of(3, 4, 5, 3, 4, 5), seen)]).toEqual([0, 1]);
});

test("light tells the sides of a facet apart", () => {
  const seen = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  expect(lightOn(seen, 0, 1, 2)).toBeCloseTo(0.79);
  expect(lightOn(seen, 0, 2, 1)).toBeCloseTo(-0.79);
  expect(lightOn(seen, 0, 1, 1)).toBe(0);
});

test("the scene rises from one posture to the other, and is not turned over", () => {
  expect(between(above, aside, 0)).toEqual(above);
  expect(between(above, aside, 1)).toEqual(aside);
  expect(turned(aside, 0, 100).tilt).toBe(Math.PI / 2);
  expect(turned(aside, 0.1, -100).tilt).toBeCloseTo(-0.35);
});

test("colours are mixed channel by channel", () => {
  expect(mix("#000000", "#ff8000", 0.5)).toBe("#804000");
});
