// Deep links: the address tells what is shown, and shows it again.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const counts = (page: Page, points: number, segments: number, holes: number) =>
  page.getByText(`Points: ${points.toLocaleString("en")}, segments: ${segments}, holes: ${holes}`).waitFor();

const hash = (page: Page) => new URL(page.url()).hash;
const slider = (page: Page) => page.getByRole("slider", { name: "Position" });

test("a run is shown again where it stood", async () => {
  const page = await theatre.visit("#preset=uniform&n=12&seed=5&algorithm=incremental&at=17");
  await counts(page, 12, 0, 0);
  await expect.poll(() => slider(page).inputValue()).toBe("17");
  await slider(page).fill("21");
  await expect.poll(() => hash(page)).toContain("at=21");
  const again = await theatre.visit(hash(page));
  await counts(again, 12, 0, 0);
  await expect.poll(() => slider(again).inputValue()).toBe("21");
  // Another address in the same page.
  await again.evaluate(() => {
    location.hash = "#mode=mesh&preset=thesis&kind=constrain&mesh.minAngle=11";
  });
  await counts(again, 9, 9, 1);
  const mode = again.getByRole("button", { name: "Mesh", exact: true });
  await expect.poll(() => mode.getAttribute("aria-current")).toBe("page");
  await expect.poll(() => hash(again)).toContain("mesh.minAngle=11");
  expect(theatre.complaints).toEqual([]);
});

test("another address counts, even where the page writes its own before it hears of that", async () => {
  const page = await theatre.visit("#preset=uniform&n=12");
  await counts(page, 12, 0, 0);
  await page.evaluate(() => {
    const own = location.href;
    location.hash = "#preset=thesis";
    history.replaceState(history.state, "", own);
  });
  await counts(page, 9, 9, 1);
  await expect.poll(() => hash(page)).toContain("preset=thesis");
  expect(theatre.complaints).toEqual([]);
});

test("a drawing is in the link, with its edits", async () => {
  const page = await theatre.visit("#preset=thesis");
  await counts(page, 9, 9, 1);
  await page.getByText("By numbers").click();
  await page.getByLabel("x", { exact: true }).fill("0.1");
  await page.getByLabel("y", { exact: true }).fill("0.3");
  await page.getByRole("button", { name: "Add point" }).click();
  await counts(page, 10, 9, 1);
  await expect.poll(() => hash(page)).toContain("drawing=");
  const again = await theatre.visit(hash(page));
  await counts(again, 10, 9, 1);
  // Undone: the preset as it is.
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Undo" }).click();
  await counts(page, 9, 9, 1);
  await expect.poll(() => hash(page)).toContain("preset=thesis");
  expect(theatre.complaints).toEqual([]);
});

test("the link is copied, and a drawing that is too large is offered to be saved", async () => {
  const page = await theatre.visit("#preset=uniform&n=10", {
    permissions: ["clipboard-read", "clipboard-write"],
  });
  await counts(page, 10, 0, 0);
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.getByText("in the clipboard").waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toContain("preset=uniform&n=10");
  const points = Array.from({ length: 1500 }, (_, i) => `${Math.sin(i)} ${Math.cos(3 * i)}`).join("\n");
  await page
    .locator("input[type=file]")
    .setInputFiles({ name: "large.csv", mimeType: "text/csv", buffer: Buffer.from(points) });
  await counts(page, 1500, 0, 0);
  await page.getByRole("button", { name: "Copy link" }).click();
  await page
    .locator(".notice")
    .filter({ hasText: "too large" })
    .getByRole("button", { name: "Save …" })
    .click();
  await page.getByRole("dialog").getByText("Picture of the stage").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test.each([
  ["#mode=dance&colour=red", "mode=dance, colour=red"],
  ["#drawing=AAAA", "drawing"],
  ["#algorithm=none", "algorithm=none"],
  ["#preset=unheard-of&n=4", "unheard-of"],
])("%s is broken: it is said, and the usual is shown", async (broken, message) => {
  const page = await theatre.visit(broken);
  await counts(page, 40, 0, 0);
  await page.locator(".notice").filter({ hasText: message }).waitFor();
  expect(theatre.complaints).toEqual([]);
});
