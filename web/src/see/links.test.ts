import { expect, test } from "vitest";
import { Links, next, OUTSIDE, previous } from "./links";
import { pointersOf } from "./pointers";

// Two triangles beside the diagonal 0–2 of a square.
const square = new Links(Uint32Array.of(0, 1, 2, 0, 2, 3));

test("half-edges know their ends, their triangle and the one back", () => {
  const h = square.find(0, 2);
  expect([square.origin(h), square.dest(h), square.apex(h)]).toEqual([0, 2, 3]);
  const twin = square.twins[h];
  expect([square.origin(twin), square.dest(twin), square.apex(twin)]).toEqual([2, 0, 1]);
  expect(square.twins[twin]).toBe(h);
  expect(square.find(1, 0)).toBe(OUTSIDE);
  expect(square.find(1, 3)).toBe(OUTSIDE);
  for (let k = 0; k < 6; k++) expect(previous(next(k))).toBe(k);
});

test("pointers lead around the triangle and around the origin", () => {
  expect(pointersOf(square, 0, 2)).toEqual({
    h: [0, 2],
    twin: [2, 0],
    next: [2, 3],
    prev: [3, 0],
    onext: [0, 3],
    oprev: [0, 1],
  });
});

test("at the hull pointers lead nowhere", () => {
  expect(pointersOf(square, 0, 1)).toEqual({
    h: [0, 1],
    twin: [1, 0],
    next: [1, 2],
    prev: [2, 0],
    onext: [0, 2],
  });
  expect(pointersOf(square, 1, 0)).toEqual({ h: [1, 0], twin: [0, 1], oprev: [1, 2] });
});

test("a fan of a hundred thousand triangles is built in no time", () => {
  const count = 100_000;
  const fan = Uint32Array.from({ length: 3 * count }, (_, i) =>
    i % 3 === 0 ? 0 : Math.floor(i / 3) + (i % 3),
  );
  const links = new Links(fan);
  const inner = links.twins.filter((twin) => twin !== OUTSIDE).length;
  expect(inner).toBe(2 * (count - 1));
});
