// Races, and the table of all algorithms.

import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

test("three race, and come to the same triangulation", async () => {
  const page = await theatre.visit();
  await page.getByRole("button", { name: "Race" }).click();
  await page.getByRole("combobox", { name: "The race takes" }).selectOption("3");
  const start = page.getByRole("button", { name: "Start", exact: true });
  await expect.poll(() => start.getAttribute("aria-disabled")).toBe("false");
  await expect.poll(() => page.locator(".lane").count()).toBe(3);
  await start.click();
  await page.getByText("All have made the same triangulation.").waitFor();
  const places = async () => (await page.locator(".lane .medal").allTextContents()).toSorted();
  await expect.poll(places).toEqual(["1.", "2.", "3."]);
  await page.screenshot({ path: "test-results/race.png" });
  // All follow one slider; by steps others may be first.
  await page.getByRole("combobox", { name: "By" }).selectOption("steps");
  await page.getByRole("slider", { name: "How far the race is" }).fill("100");
  await expect.poll(() => page.locator(".lane .medal").count()).toBeLessThan(3);
  const steps = page.locator(".lane dl > div:nth-child(2) dd");
  await expect.poll(async () => new Set(await steps.allTextContents()).size).toBe(1);
  expect(theatre.complaints).toEqual([]);
});

test("racers are chosen, and one may go", async () => {
  const page = await theatre.visit();
  await page.getByRole("button", { name: "Race" }).click();
  await page.getByRole("combobox", { name: "Racer 1" }).selectOption("fortune");
  await page.getByRole("heading", { name: "Fortune's sweep" }).waitFor();
  await page.getByRole("button", { name: "Without the third" }).click();
  await expect.poll(() => page.locator(".lane").count()).toBe(2);
  // The run on the stage is still there.
  await page.getByRole("button", { name: "Play", exact: true }).first().click();
  await page.getByText("Before the first step.").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("all algorithms are compared in a table that can be sorted", async () => {
  const page = await theatre.visit();
  await page.getByRole("button", { name: "Race" }).click();
  await expect.poll(() => page.locator(".lane").count()).toBe(3);
  await page.getByRole("button", { name: "Compare all" }).click();
  await page.getByRole("button", { name: "Compare again" }).waitFor();
  const rows = page.locator(".compare tbody tr");
  await expect.poll(() => page.getByRole("button", { name: "Compare again" }).isEnabled()).toBe(true);
  await expect.poll(() => rows.count()).toBeGreaterThan(12);
  await expect
    .poll(() => page.getByRole("img", { name: "The library's triangulation" }).count())
    .toBeGreaterThan(8);
  await page.getByRole("button", { name: "Steps", exact: true }).click();
  const steps = async () => {
    const cells = await rows.locator("td:nth-child(3)").allTextContents();
    return cells.map((cell) => Number(cell.replaceAll(",", "")));
  };
  const sorted = (await steps()).toSorted((a, b) => a - b);
  await expect.poll(steps).toEqual(sorted);
  // Its own runs do not disturb the race.
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.getByRole("button", { name: "Pause" }).waitFor();
  expect(theatre.complaints).toEqual([]);
});
