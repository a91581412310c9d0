import { expect, test } from "vitest";
import { presets as german } from "../words/de/presets";
import { presets as english } from "../words/en/presets";
import { boundsOf, within } from "./bounds";

test("numbers keep to the bounds of their preset", () => {
  const bounds = boundsOf({ name: "tangle", about: "", kind: "domain", sized: true });
  expect(within(bounds, 1e6)).toBe(2000);
  expect(within(bounds, -4)).toBe(bounds.least);
  expect(within(bounds, 7.4)).toBe(7);
  expect(within(bounds, Number.NaN)).toBe(bounds.usual);
});

test("presets have titles in both languages", () => {
  expect(Object.keys(german)).toEqual(Object.keys(english));
});
