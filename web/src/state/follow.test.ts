import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { follow } from "./follow";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

function setUp() {
  const [a, b, isOn, isBusy] = [signal(1), signal("x"), signal(true), signal(false)];
  const act = vi.fn(() => {
    follower.accept();
  });
  const follower = follow(() => (isOn.value ? [a.value, b.value] : null), isBusy, act);
  vi.runAllTimers();
  return { a, b, isOn, isBusy, act, follower };
}

test("whoever asks knows that something is about to be done", () => {
  const { a, act, follower } = setUp();
  expect(follower.isDue()).toBe(false);
  a.value = 2;
  expect(follower.isDue()).toBe(true);
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(2);
  expect(follower.isDue()).toBe(false);
});

test("changes that come together are one, and what is known is none", () => {
  const { a, b, act, follower } = setUp();
  expect(act).toHaveBeenCalledTimes(1);
  a.value = 2;
  b.value = "y";
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(2);
  a.value = 3;
  follower.accept();
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(2);
});

test("who is busy is left alone until that is over", () => {
  const { a, isBusy, isOn, act } = setUp();
  isBusy.value = true;
  a.value = 2;
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(1);
  isBusy.value = false;
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(2);
  isOn.value = false;
  a.value = 5;
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(2);
  isOn.value = true;
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(3);
});

test("what is lost is done again, unless there is something newer", () => {
  const { a, b, act, follower } = setUp();
  const first = follower.accept();
  a.value = 2;
  vi.runAllTimers();
  follower.forget(first);
  b.value = "y";
  b.value = "x";
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(2);
  follower.forget(follower.accept());
  b.value = "z";
  b.value = "x";
  vi.runAllTimers();
  expect(act).toHaveBeenCalledTimes(3);
});
