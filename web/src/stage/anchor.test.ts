// From 64 bits to 32: places on the screen come out as exactly as promised.

import { expect, test } from "vitest";
import { anchorOf, isFine, place, relative, relativeCamera } from "./anchor";
import { boxOf, type Camera, fit, toScreen, zoom } from "./camera";

const size = { width: 800, height: 600 };
const { fround } = Math;

/** What the graphics processor makes of a point, number by number as it counts. */
function onDevice(points: Float64Array, vertex: number, camera: Camera): [number, number] {
  const anchor = anchorOf(boxOf(points));
  const placed = place(points, anchor);
  const eye = relativeCamera(camera, anchor);
  const axis = (value: number, middle: number) => fround(fround(value - fround(middle)) * fround(eye.scale));
  return [
    size.width / 2 + axis(placed[2 * vertex], eye.x),
    size.height / 2 - axis(placed[2 * vertex + 1], eye.y),
  ];
}

const drawings: Record<string, Float64Array> = {
  unit: Float64Array.of(0, 0, 1, 0, 0.3, 0.7),
  utm: Float64Array.of(500_000, 5_400_000, 500_100, 5_400_000, 500_033.3, 5_400_077.7),
  small: Float64Array.of(0, 0, 1e-300, 0, 3e-301, 7e-301),
  large: Float64Array.of(-1e300, 0, 1e300, 0, 3e299, 7e299),
  huge: Float64Array.of(-1.7e308, -1.7e308, 1.7e308, 0, 3e307, 1.7e308),
};

test.each(Object.entries(drawings))("%s: points are where they belong", (_, points) => {
  let camera = fit(boxOf(points), size);
  for (let k = 0; k < 12 && isFine(camera, anchorOf(boxOf(points)), 1); k++) {
    const [x, y] = toScreen(camera, size, points[4], points[5]);
    const [px, py] = onDevice(points, 2, camera);
    expect(Math.abs(px - x)).toBeLessThan(0.26);
    expect(Math.abs(py - y)).toBeLessThan(0.26);
    camera = zoom(camera, size, 4, x, y);
  }
});

test("it is noticed when 32 bits are not enough", () => {
  const { utm } = drawings;
  const anchor = anchorOf(boxOf(utm));
  const camera = fit(boxOf(utm), size);
  expect(isFine(camera, anchor, 1)).toBe(true);
  expect(isFine({ ...camera, scale: camera.scale * 1e4 }, anchor, 1)).toBe(false);
});

test("what overflows on the way stays a number", () => {
  expect(relative(1.7e308, -1.7e308, 1e308)).toBeCloseTo(3.4);
  expect(relative(1e308, -1e308, 1e-308)).toBe(1e150);
  expect(relative(5e-324, 0, 5e-324)).toBe(1);
});
