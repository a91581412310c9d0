// Two visits from beginning to end: somebody who sees the page for the first time, and somebody who teaches with it.

import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const slider = (page: Page) => page.getByRole("slider", { name: "Position" });
const at = async (page: Page) => Number(await slider(page).inputValue());
const said = (page: Page) => page.locator(".narration p").first();

/** Drops a file on the page, as hands do. */
const drop = (page: Page, name: string, content: string) =>
  page.evaluate(
    ([name, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], name));
      for (const kind of ["dragover", "drop"])
        document.body.dispatchEvent(
          new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }),
        );
    },
    [name, content],
  );

/** Saves something; returns its name and its bytes. */
async function save(page: Page, what: string, extension: string | null, more = async () => {}) {
  await page.getByRole("button", { name: "Save …" }).click();
  await page.getByRole("radio", { name: what, exact: true }).check();
  if (extension) await page.getByLabel("Format").selectOption(extension);
  await more();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("dialog").getByRole("button", { name: "Save" }).click(),
  ]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test("the newcomer's minute", async () => {
  const begin = performance.now();
  const page = await theatre.visit();
  // The sweep is there, and plays at a pace that can be followed.
  await page.getByText("Before the first step.").waitFor();
  await page.getByRole("button", { name: "Play", exact: true }).last().click();
  await expect.poll(() => at(page)).toBeGreaterThan(8);
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await expect.poll(() => said(page).textContent()).not.toBe("Before the first step.");
  // A flip, and back over it. It may stand on one already.
  await settled(page);
  const paused = await at(page);
  await page.keyboard.press("f");
  await expect.poll(() => at(page)).toBeGreaterThan(paused);
  await expect.poll(() => said(page).textContent()).toContain("is flipped");
  const flip = await at(page);
  await page.keyboard.press("ArrowLeft");
  await expect.poll(() => said(page).textContent()).not.toContain("is flipped");
  await expect.poll(() => at(page)).toBe(flip - 1);
  // A file of one's own, meshed and saved.
  await drop(page, "plate.wkt", "POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0), (2 1, 4 1, 4 3, 2 3, 2 1))");
  await page.getByText("Points: 8, segments: 8, holes: 0").waitFor();
  await page.getByRole("button", { name: "Mesh", exact: true }).click();
  await page.getByRole("button", { name: "Mesh it" }).click();
  await page.locator(".mesh-outcome").waitFor();
  const { name, bytes } = await save(page, "Mesh", "vtu");
  expect(name).toBe("plate.vtu");
  expect(bytes.toString("latin1")).toContain("UnstructuredGrid");
  await page.screenshot({ path: "test-results/newcomer.png" });
  // Some seconds, alone; how much is left of a busy machine says nothing about the page. A hang ends the test.
  console.log(`the newcomer's minute: ${((performance.now() - begin) / 1000).toFixed(1)} s`);
  expect(theatre.complaints).toEqual([]);
});

test("a lecture: a link to a moment, overlays, and pictures to take along", async () => {
  const page = await theatre.visit(
    "#preset=uniform&n=14&seed=3&algorithm=flip-list&at=100&see=marks,circle,numbers",
  );
  await expect.poll(() => at(page)).toBe(100);
  const see = (name: string) => page.getByRole("checkbox", { name, exact: true });
  await expect.poll(() => see("Numbers").isChecked()).toBe(true);
  await expect.poll(() => see("Front").isChecked()).toBe(false);
  await see("Voronoi cells").check();
  await see("Numbers").uncheck();
  // The address follows later, perhaps in two steps.
  await expect.poll(() => page.url()).toMatch(/^(?!.*numbers).*voronoi/);
  const svg = await save(page, "Run", "svg", () => page.getByLabel("Seconds").fill("2"));
  expect(svg.bytes.toString()).toContain("<svg");
  const small = async () => {
    await page.getByLabel("Width in pixels").fill("240");
    await page.getByLabel("Seconds").fill("1");
  };
  const gif = await save(page, "Run", "gif", small);
  expect(gif.bytes.subarray(0, 3).toString()).toBe("GIF");
  const video = await save(page, "Run", "webm", small);
  // The mark of EBML.
  expect(video.bytes.readUInt32BE(0)).toBe(0x1a45dfa3);
  const picture = await save(page, "Picture of the stage", null);
  expect(picture.bytes.subarray(1, 4).toString()).toBe("PNG");
  await page.screenshot({ path: "test-results/lecture.png" });
  expect(theatre.complaints).toEqual([]);
});

test("with everything enlarged, colours forced and less motion there is a stage, and what runs is marked", async () => {
  const page = await theatre.visit("#preset=uniform&n=14&seed=3&algorithm=flip-list&at=60", {
    viewport: { width: 640, height: 360 },
    forcedColors: "active",
    reducedMotion: "reduce",
  });
  const line = page.locator('.code [aria-current="step"]');
  await line.waitFor();
  const background = (of: typeof line) => of.evaluate((element) => getComputedStyle(element).backgroundColor);
  const isMarked = async (one: typeof line, other: typeof line) =>
    (await background(one)) !== (await background(other));
  await expect.poll(() => isMarked(line, page.locator(".code"))).toBe(true);
  const tabs = page.getByRole("navigation").getByRole("button");
  for (const [i, name] of ["Play", "Predict", "Race", "Mesh"].entries()) {
    await tabs.filter({ hasText: name }).click();
    await expect.poll(() => isMarked(tabs.nth(i), tabs.nth((i + 1) % 4)), { message: name }).toBe(true);
    const stage = page.locator(".stage, .lanes").first();
    await stage.waitFor();
    await expect.poll(async () => (await stage.boundingBox())?.height).toBeGreaterThan(100);
    await settled(page);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(640);
  }
  expect(theatre.complaints).toEqual([]);
});
