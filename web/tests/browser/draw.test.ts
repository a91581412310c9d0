// Drawing: points, rings and holes, moved, taken back, and marked where they are wrong.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** Waits until the panel counts this. */
const counts = (page: Page, points: number, segments: number, holes: number) =>
  page
    .getByText(
      `Points: ${points.toLocaleString("en")}, segments: ${segments.toLocaleString("en")}, holes: ${holes}`,
    )
    .waitFor();

/** Returns where a part of the stage is on the page. */
async function place(page: Page, x: number, y: number): Promise<[number, number]> {
  const box = (await page.locator(".stage").boundingBox())!;
  return [box.x + x * box.width, box.y + y * box.height];
}

const click = async (page: Page, x: number, y: number) => page.mouse.click(...(await place(page, x, y)));

async function empty(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Start empty" }).click();
  await counts(page, 0, 0, 0);
}

async function ring(page: Page): Promise<void> {
  await page.keyboard.press("s");
  for (const [x, y] of [
    [0.3, 0.3],
    [0.7, 0.3],
    [0.7, 0.7],
    [0.3, 0.7],
    [0.3, 0.3],
  ])
    await click(page, x, y);
}

test("what is being typed stays when another drawing comes", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  const count = page.getByRole("spinbutton", { name: "Points" });
  const seed = page.getByRole("spinbutton", { name: "Seed" }).first();
  await count.fill("77");
  await page.getByRole("button", { name: "Another seed" }).first().dispatchEvent("click");
  await expect.poll(() => seed.inputValue()).not.toBe("1");
  expect(await count.inputValue()).toBe("77");
  await count.press("Tab");
  await counts(page, 77, 0, 0);
  await expect.poll(() => seed.inputValue()).not.toBe("1");
  expect(theatre.complaints).toEqual([]);
});

test("points are added, moved and removed, and taken back", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  await empty(page);
  await page.keyboard.press("p");
  for (const x of [0.3, 0.5, 0.7]) await click(page, x, x);
  await counts(page, 3, 0, 0);
  await page.mouse.move(...(await place(page, 0.5, 0.5)));
  await page.mouse.down();
  for (let step = 0; step < 10; step++) await page.mouse.move(...(await place(page, 0.5 + step / 50, 0.5)));
  await page.mouse.up();
  // It is no longer where it was, but where it was let go.
  await page.keyboard.down("Shift");
  await click(page, 0.5, 0.5);
  await click(page, 0.68, 0.5);
  await page.keyboard.up("Shift");
  await counts(page, 2, 0, 0);
  // The drag was one edit.
  await page.keyboard.press("Control+z");
  await counts(page, 3, 0, 0);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await counts(page, 2, 0, 0);
  await page.keyboard.press("Control+Shift+Z");
  await counts(page, 3, 0, 0);
  await page.getByRole("button", { name: "Undo" }).click();
  await page.keyboard.press("Control+y");
  await counts(page, 3, 0, 0);
  expect(theatre.complaints).toEqual([]);
});

test("what is removed faster than the page follows is what was clicked", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  await empty(page);
  await page.keyboard.press("p");
  for (const x of [0.3, 0.5, 0.7]) await click(page, x, x);
  await counts(page, 3, 0, 0);
  await page.keyboard.press("e");
  // Both before the page can have made the first edit, which changes the numbers of the points behind it.
  const places = [await place(page, 0.3, 0.3), await place(page, 0.5, 0.5)];
  await page
    .locator(".stage-view canvas")
    .last()
    .evaluate((canvas, all) => {
      for (const [clientX, clientY] of all)
        for (const kind of ["pointerdown", "pointerup"])
          canvas.dispatchEvent(
            new PointerEvent(kind, { clientX, clientY, pointerId: 1, isPrimary: true, bubbles: true }),
          );
    }, places);
  await counts(page, 1, 0, 0);
  await click(page, 0.7, 0.7);
  await counts(page, 0, 0, 0);
  expect(theatre.complaints).toEqual([]);
});

test("a ring closes at its first point, has a hole, and is cut by a point on it", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  await empty(page);
  await ring(page);
  await counts(page, 4, 4, 0);
  await page.keyboard.press("h");
  await click(page, 0.5, 0.5);
  await counts(page, 4, 4, 1);
  await page.screenshot({ path: "test-results/ring.png" });
  await page.keyboard.press("p");
  await click(page, 0.5, 0.3);
  await counts(page, 5, 5, 1);
  await page.keyboard.press("e");
  await click(page, 0.3, 0.3);
  await counts(page, 4, 3, 1);
  await click(page, 0.5, 0.5);
  await counts(page, 4, 3, 0);
  await page.getByRole("button", { name: "Remove everything" }).click();
  await counts(page, 0, 0, 0);
  await page.keyboard.press("Control+z");
  await counts(page, 4, 3, 0);
  expect(theatre.complaints).toEqual([]);
});

test("the view moves by a drag of what is empty, with any tool", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  await empty(page);
  await page.keyboard.press("p");
  await click(page, 0.4, 0.4);
  await counts(page, 1, 0, 0);
  await page.mouse.move(...(await place(page, 0.6, 0.6)));
  await page.mouse.down();
  await page.mouse.move(...(await place(page, 0.7, 0.6)), { steps: 5 });
  await page.mouse.up();
  await counts(page, 1, 0, 0);
  await page.keyboard.down("Shift");
  await click(page, 0.5, 0.4);
  await page.keyboard.up("Shift");
  await counts(page, 0, 0, 0);
  expect(theatre.complaints).toEqual([]);
});

test("fingers draw", async () => {
  const page = await theatre.visit("", { viewport: { width: 390, height: 844 }, hasTouch: true });
  await page.getByRole("button", { name: "Drawing", exact: true }).tap();
  await page.getByRole("button", { name: "Start empty" }).tap();
  await counts(page, 0, 0, 0);
  await page.getByRole("button", { name: "Points", exact: true }).tap();
  for (const x of [0.3, 0.6]) await page.touchscreen.tap(...(await place(page, x, 0.6)));
  await counts(page, 2, 0, 0);
  await page.screenshot({ path: "test-results/draw-phone.png" });
  expect(theatre.complaints).toEqual([]);
});

test("numbers draw without a pointer", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  await empty(page);
  await page.getByText("By numbers").click();
  for (const [x, y] of [
    [0, 0],
    [4, 0],
    [0, 3],
  ]) {
    await page.getByLabel("x", { exact: true }).fill(String(x));
    await page.getByLabel("y", { exact: true }).fill(String(y));
    await page.getByRole("button", { name: "Add point" }).click();
  }
  await counts(page, 3, 0, 0);
  await page.getByLabel("from", { exact: true }).fill("0");
  await page.getByLabel("to", { exact: true }).fill("2");
  await page.getByLabel("to", { exact: true }).press("Enter");
  await counts(page, 3, 1, 0);
  await page.getByLabel("to", { exact: true }).fill("9");
  await page.getByLabel("to", { exact: true }).press("Enter");
  await page.getByRole("alert").filter({ hasText: "no point 9" }).waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("crossing segments are marked, and shown, until they are changed", async () => {
  const page = await theatre.visit("#mode=mesh&preset=degenerate-grid");
  await counts(page, 64, 14, 0);
  await page.getByRole("button", { name: "Mesh it" }).click();
  const alert = page.getByRole("alert").filter({ hasText: "cross" });
  await alert.getByRole("button", { name: "Show" }).click();
  await page.screenshot({ path: "test-results/troubles.png" });
  await page.getByRole("button", { name: "Remove everything" }).click();
  await alert.waitFor({ state: "detached" });
  expect(theatre.complaints).toEqual([]);
});

test("every preset has a title, and is drawn within its bounds", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  const select = page.getByLabel("Preset");
  // All but the first one come from the module.
  await expect.poll(() => select.locator("option").count()).toBeGreaterThan(25);
  const options = await select
    .locator("option")
    .evaluateAll((all) =>
      all.map((each) => ({ value: (each as HTMLOptionElement).value, text: each.textContent })),
    );
  for (const { value, text } of options) expect(text).not.toBe(value);
  await select.selectOption("tangle");
  await counts(page, 40, 20, 0);
  const field = page.getByRole("spinbutton", { name: "Segments" });
  await field.fill("99999");
  await field.press("Enter");
  await counts(page, 4000, 2000, 0);
  await expect.poll(() => field.inputValue()).toBe("2000");
  expect(theatre.complaints).toEqual([]);
});
