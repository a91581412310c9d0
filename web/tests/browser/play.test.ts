// Playing: to the end, and back.

import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

test("a run is stepped to its end and back", async () => {
  const page = await theatre.visit();
  await page.getByRole("button", { name: "To the end" }).click();
  const step = page.getByRole("button", { name: "Step", exact: true });
  await step.waitFor();
  expect(await step.isDisabled()).toBe(true);
  await page.screenshot({ path: "test-results/play.png" });
  await page.getByRole("button", { name: "To the beginning" }).click();
  await page.getByText("Before the first step.").waitFor();
  expect(theatre.complaints).toEqual([]);
});
