// What keys mean, and how they are listed.

import { describe, expect, test, vi } from "vitest";
import { bind, listed, meaning } from "./shortcuts";

const key = (key: string, shiftKey = false, ctrlKey = false) => ({ key, shiftKey, ctrlKey, metaKey: false });

describe("keys", () => {
  const [page, race, shifted] = [vi.fn(), vi.fn(), vi.fn()];
  bind("page", "q", "help", page);
  bind("race", "q", "first", race);
  bind("page", "Shift+ArrowLeft", "previous", shifted);
  bind("page", "%", "escape", page);

  test("that of the mode comes first", () => {
    expect(meaning("race", key("q"))).toBe(race);
    expect(meaning("play", key("q"))).toBe(page);
    expect(meaning("play", key("Q", true))).toBeUndefined();
  });
  test("Shift matters, except for signs", () => {
    expect(meaning("play", key("ArrowLeft", true))).toBe(shifted);
    expect(meaning("play", key("ArrowLeft"))).toBeUndefined();
    expect(meaning("play", key("%", true))).toBe(page);
  });
  test("Control is another key", () => {
    expect(meaning("play", key("q", false, true))).toBeUndefined();
  });
  test("the latest meaning holds, and is listed once", () => {
    bind("race", "q", "last", page);
    expect(meaning("race", key("q"))).toBe(page);
    expect(listed("race")).toEqual([{ does: "last", keys: ["q"] }]);
  });
});
