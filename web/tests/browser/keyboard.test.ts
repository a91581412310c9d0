// Everything by keys alone: no mouse is moved here, and nothing gets the focus but by the Tab key.

import { readFileSync } from "node:fs";
import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

async function visit(): Promise<Page> {
  const page = await theatre.visit("", { viewport: { width: 1280, height: 720 } });
  await settled(page);
  return page;
}

/** Presses Tab until this has the focus, which must be seen then. */
async function tabTo(page: Page, goal: Locator): Promise<void> {
  await goal.first().waitFor();
  for (let i = 0; i < 150; i++) {
    await page.keyboard.press("Tab");
    const outline = await goal.evaluateAll((all) => {
      const one = all.find((each) => each === document.activeElement);
      return one ? getComputedStyle(one).outlineStyle : null;
    });
    if (outline === null) continue;
    expect(outline).not.toBe("none");
    return;
  }
  throw new Error(`no way by Tab to ${goal}`);
}

const button = (page: Page, name: string | RegExp) => page.getByRole("button", { name, exact: true });
const position = async (page: Page) => Number(await page.getByLabel("Position").inputValue());

test("played, stepped back, opened, meshed, saved", async () => {
  const page = await visit();
  await page.keyboard.press("Tab");
  expect(await page.locator(":focus").textContent()).toBe("Skip to the stage");
  await page.keyboard.press("Enter");
  await expect.poll(() => page.evaluate(() => document.activeElement?.id)).toBe("stage");

  await page.keyboard.press(" ");
  await expect.poll(() => position(page)).toBeGreaterThan(1);
  await page.keyboard.press(" ");
  await page
    .getByRole("region", { name: "Playing" })
    .getByRole("button", { name: "Play", exact: true })
    .waitFor();
  const at = await position(page);
  await page.keyboard.press("ArrowLeft");
  await expect.poll(() => position(page)).toBeLessThan(at);

  // Playwright only begins to catch the chooser then: right before the key it would come too late at times.
  const chooser = page.waitForEvent("filechooser");
  await tabTo(page, button(page, "Open …"));
  await page.keyboard.press("Enter");
  await (await chooser).setFiles({ name: "own.csv", mimeType: "text/csv", buffer: Buffer.from(square) });
  await page.getByText("Points: 5").waitFor();

  await tabTo(page, page.locator(".modes button").last());
  await page.keyboard.press("Enter");
  await tabTo(page, button(page, "Mesh it"));
  await page.keyboard.press("Enter");
  await page.locator(".mesh-outcome").getByText("triangles").waitFor();
  await tabTo(page, button(page, "Save …"));
  await page.keyboard.press("Enter");
  await page.getByRole("dialog").waitFor();
  await tabTo(page, page.getByRole("dialog").getByRole("button", { name: "Save" }));
  const [saved] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  expect(readFileSync(await saved.path()).length).toBeGreaterThan(50);
  await expect.poll(() => page.getByText("(done)").count()).toBe(4);
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
});

const square = "x,y\n0,0\n4,0\n4,3\n0,3\n2,1\n";

test("the focus goes the way in which the page is read", async () => {
  const page = await visit();
  const order: string[] = [];
  for (let i = 0; i < 150 && order.at(-1) !== "work"; i++) {
    await page.keyboard.press("Tab");
    const room = await page
      .locator(":focus")
      .evaluate((one) => one.closest(".head, .side, .middle, .work")?.classList[0]);
    if (room && room !== order.at(-1)) order.push(room);
  }
  expect(order).toEqual(["head", "side", "middle", "work"]);
  await page.setViewportSize({ width: 800, height: 1100 });
  const below = () =>
    page.locator(".head, .side, .middle, .work").evaluateAll((all) => all.map((one) => one.classList[0]));
  await expect.poll(below).toEqual(["head", "middle", "side", "work"]);
  await page.context().close();
});

test("the help lists the keys, and leads back to what to try first", async () => {
  const page = await visit();
  await button(page, "Do not show this again").click();
  await page.reload();
  await settled(page);
  expect(await page.getByText("The first minute").count()).toBe(0);
  await page.keyboard.press("?");
  const help = page.getByRole("dialog", { name: "Help" });
  for (const told of ["This list", "Zoom in", "Undo", "Tool: points"]) await help.getByText(told).waitFor();
  await tabTo(page, help.getByRole("button", { name: "Show what to try first" }));
  await page.keyboard.press("Enter");
  await page.getByRole("region", { name: "The first minute" }).waitFor();
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
});

test("panels fold away, and stay so", async () => {
  const page = await visit();
  const stage = page.locator(".middle");
  const width = async () => (await stage.boundingBox())?.width;
  const before = (await width())!;
  await button(page, "Drawing and view").click();
  await button(page, "What is done with it").click();
  await expect.poll(width).toBeGreaterThan(before + 500);
  await page.reload();
  await expect.poll(width).toBeGreaterThan(before + 500);
  await page.context().close();
});
