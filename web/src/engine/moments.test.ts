import { expect, test } from "vitest";
import { countMoments } from "./moments";

const after = (moments: number[]) => (from: number) => moments.find((moment) => moment > from);

test("every moment is counted in its stretch", () => {
  expect([...countMoments(after([1, 2, 3, 10]), 10, 5)]).toEqual([2, 1, 0, 0, 1]);
  expect([...countMoments(after([]), 10, 3)]).toEqual([0, 0, 0]);
  expect([...countMoments(after([1, 2]), 2, 4)]).toEqual([1, 0, 1, 0]);
});

test("a run without steps has no moments", () => {
  expect([...countMoments(() => 1, 0, 2)]).toEqual([0, 0]);
});

test("full stretches are skipped", () => {
  let asked = 0;
  const every = (from: number) => {
    asked += 1;
    return from < 1_000_000 ? from + 1 : undefined;
  };
  const counts = countMoments(every, 1_000_000, 10);
  expect([...counts]).toEqual(Array(10).fill(64));
  expect(asked).toBeLessThan(1000);
});
