// The camera, also where numbers end.

import { expect, test } from "vitest";
import { type Box, boxOf, fit, hold, pan, toPlane, toScreen, zoom } from "./camera";

const size = { width: 800, height: 600 };
const max = Number.MAX_VALUE;
const boxes: Record<string, Box> = {
  unit: { low: [0, 0], high: [1, 1] },
  utm: { low: [500_000, 5_400_000], high: [500_100, 5_400_080] },
  point: { low: [3, 4], high: [3, 4] },
  nothing: { low: [0, 0], high: [0, 0] },
  flat: { low: [-1, 2], high: [1, 2] },
  huge: { low: [-max, -max], high: [max, max] },
  large: { low: [-1e300, 0], high: [1e300, 1e300] },
  small: { low: [-1e-300, 0], high: [1e-300, 1e-300] },
  least: { low: [0, 0], high: [5e-324, 5e-324] },
  corner: { low: [max, max], high: [max, max] },
  mixed: { low: [-max, 0], high: [max, 5e-324] },
};

test.each(Object.entries(boxes))("%s: what is done to the camera leaves numbers", (_, box) => {
  let camera = fit(box, size);
  const isGood = () => {
    for (const value of [camera.x, camera.y, camera.scale, 1 / camera.scale]) {
      expect(Number.isFinite(value)).toBe(true);
    }
    expect(camera.scale).toBeGreaterThan(0);
    for (const [px, py] of [
      [0, 0],
      [1e4, -1e4],
    ]) {
      const place = toPlane(camera, size, px, py);
      expect(place.every(Number.isFinite)).toBe(true);
      expect(toScreen(camera, size, ...place).every(Number.isFinite)).toBe(true);
    }
    expect(toScreen(camera, size, max, -max).every(Number.isFinite)).toBe(true);
  };
  isGood();
  for (const factor of [1e6, 1e300, 1e300, 1e300, 1e-300, 1e-300, 1e-300, 1e-300, 1e-300]) {
    camera = zoom(camera, size, factor, 17, 400);
    isGood();
    camera = pan(camera, 1e5, -1e5);
    isGood();
    camera = hold(camera, size, [max, -max], 5, 5);
    isGood();
  }
});

test.each(["unit", "utm", "flat", "huge", "large", "small"])("%s: all of a box is seen", (name) => {
  const box = boxes[name];
  const camera = fit(box, size);
  const corners = [toScreen(camera, size, ...box.low), toScreen(camera, size, ...box.high)];
  for (const [px, py] of corners) {
    expect(px).toBeGreaterThanOrEqual(0);
    expect(px).toBeLessThanOrEqual(size.width);
    expect(py).toBeGreaterThanOrEqual(0);
    expect(py).toBeLessThanOrEqual(size.height);
  }
  // And it is not small.
  const [wide, high] = [corners[1][0] - corners[0][0], corners[0][1] - corners[1][1]];
  expect(Math.max(wide / size.width, high / size.height)).toBeGreaterThan(0.85);
});

test("the place under the pixel stays there", () => {
  const camera = fit(boxes.utm, size);
  const place = toPlane(camera, size, 100, 100);
  const zoomed = zoom(camera, size, 1000, 100, 100);
  const [px, py] = toScreen(zoomed, size, ...place);
  expect(px).toBeCloseTo(100, 2);
  expect(py).toBeCloseTo(100, 2);
  expect(toPlane(hold(camera, size, place, 250, 30), size, 250, 30)).toEqual(place);
});

test("zooming in ends where neighbouring numbers are seen apart", () => {
  let camera = fit(boxes.utm, size);
  for (let k = 0; k < 100; k++) camera = zoom(camera, size, 10, 400, 300);
  expect(camera.scale * 2 ** -30).toBeLessThan(32);
  expect(camera.scale * 2 ** -30).toBeGreaterThan(4);
});

test("a box is the smallest one", () => {
  expect(boxOf(Float64Array.of(1, 5, -2, 3, 0, 4))).toEqual({ low: [-2, 3], high: [1, 5] });
  expect(boxOf(new Float64Array())).toEqual({ low: [0, 0], high: [1, 1] });
});
