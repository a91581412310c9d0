// Without a network: the page keeps itself where it may, and does all it can do.

import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

test("once visited it works without a network", async () => {
  const page = await theatre.visit("");
  // Kept under the name of this machine, not under its number: there it is the program that serves.
  await page.goto(theatre.address.replace("127.0.0.1", "localhost"));
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.context().setOffline(true);
  await page.reload();
  await page.getByRole("navigation", { name: "What to do" }).getByRole("button", { name: "Mesh" }).click();
  await page.getByRole("button", { name: "Mesh it", exact: true }).click();
  await page.locator(".mesh-outcome").getByText("triangles").waitFor();
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
});

test("the program's page leaves nothing behind", async () => {
  const page = await theatre.visit("");
  await settled(page);
  expect(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length)).toBe(0);
  expect(await page.evaluate(() => caches.keys())).toEqual([]);
  await page.context().close();
});
