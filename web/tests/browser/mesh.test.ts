// The page as a tool: large meshes with progress, cancelled and made again; their quality; why a triangle is there; files
// that are read again.

import { readFileSync } from "node:fs";
import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Drawing, initSync, Mesh } from "../../src/wasm/delone.js";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  initSync({ module: readFileSync(new URL("../../src/wasm/delone_bg.wasm", import.meta.url)) });
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** Opens the page for meshing a preset. */
async function visit(preset: string): Promise<Page> {
  const page = await theatre.visit();
  await page.getByRole("button", { name: "Mesh", exact: true }).click();
  await page.getByLabel("Preset").selectOption(preset);
  await settled(page);
  return page;
}

const panel = (page: Page): Locator => page.getByRole("region", { name: "Mesh", exact: true });
const outcome = (page: Page): Locator => page.locator(".mesh-outcome");
const meshIt = (page: Page): Locator => page.getByRole("button", { name: "Mesh it" });
const tab = (page: Page, name: string): Promise<void> => page.getByRole("tab", { name }).click();

/** Waits for an outcome other than the one before, and returns its triangles. */
async function triangles(page: Page, before = ""): Promise<number> {
  const next = outcome(page).filter({ hasNotText: before || "nothing like this" });
  await next.waitFor();
  return Number((await next.textContent())!.match(/([\d,]+) triangles/)![1].replaceAll(",", ""));
}

async function hash(page: Page): Promise<string> {
  await tab(page, "Export");
  const code = page.locator(".mesh-copy code").filter({ hasText: /^[0-9a-f]{32}$/ });
  return (await code.textContent())!;
}

/** Clicks in the middle of the stage until a triangle is hit, and returns its heading. */
async function ask(page: Page, x: number, y: number): Promise<Locator> {
  const box = (await page.locator(".stage-view").boundingBox())!;
  await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  const heading = page.getByRole("heading", { name: /^Triangle \d/ });
  await heading.waitFor();
  return heading;
}

test("a large mesh is made with progress, cancelled at once, and made again", async () => {
  const page = await visit("lake");
  const edge = panel(page).getByLabel("Longest edge", { exact: true });
  await edge.fill("0.02");
  await meshIt(page).click();
  expect(await triangles(page)).toBeGreaterThan(1e5);
  const known = await hash(page);
  await tab(page, "Options");

  // More than it can have: it works until it is told to stop.
  await edge.fill("0.004");
  await meshIt(page).click();
  const cancel = panel(page).getByRole("button", { name: "Cancel" });
  await panel(page).getByText("Refining").waitFor();
  await panel(page)
    .getByText(/of about/)
    .waitFor();
  // Frames go on while the worker works.
  const frames = await page.evaluate(async () => {
    const gaps: number[] = [];
    let last = performance.now();
    for (let k = 0; k < 20; k++) {
      const now = await new Promise<number>((next) => requestAnimationFrame(() => next(performance.now())));
      gaps.push(now - last);
      last = now;
    }
    return gaps.sort((a, b) => a - b);
  });
  // Measured in the page, where a click has not waited for much else, and in frames, which a busy machine makes longer
  // and not more: nothing is waited for, so the next one shows it.
  const heard = await cancel.evaluate(async (button: HTMLElement) => {
    let count = 0;
    button.click();
    for (; button.isConnected; count++) await new Promise(requestAnimationFrame);
    return count;
  });
  console.log(`median frame ${frames[10].toFixed(0)} ms while meshing; cancelled within ${heard} frames`);
  expect(heard).toBeLessThanOrEqual(2);
  await panel(page).getByText("Other options are chosen by now.").waitFor();

  // The mesh before is still there, also for questions, and the next one comes.
  await ask(page, 0.5, 0.5);
  await tab(page, "Options");
  const before = await outcome(page).textContent();
  await edge.fill("0.5");
  await meshIt(page).click();
  expect(await triangles(page, before!)).toBeLessThan(5000);
  await edge.fill("0.02");
  await meshIt(page).click();
  await outcome(page).filter({ hasText: before! }).waitFor();
  expect(await hash(page)).toBe(known);
  expect(theatre.complaints).toEqual([]);
});

test("quality is shown, bars show their triangles, and quick meshes follow", async () => {
  const page = await visit("lake");
  // Which mesh is quick the worker's clock says: here all are, be the machine as busy as it may.
  for (const worker of page.workers())
    await worker.evaluate(() => {
      performance.now = () => 0;
    });
  await panel(page).getByLabel("Smallest angle", { exact: true }).press("Enter");
  const count = await triangles(page);
  const before = (await outcome(page).textContent())!;
  await panel(page).getByLabel("Smallest angle", { exact: true }).fill("30");
  expect(await triangles(page, before)).toBeGreaterThan(count);
  await tab(page, "Quality");
  const bars = panel(page).getByRole("button", { name: /^\d+° to \d+°: [\d,]+ triangles$/ });
  const counts = async () =>
    (await bars.evaluateAll((all) => all.map((bar) => bar.getAttribute("aria-label")!))).map((label) =>
      Number(label.match(/: ([\d,]+)/)![1].replaceAll(",", "")),
    );
  const all = await triangles(page);
  await expect.poll(async () => (await counts()).reduce((a, b) => a + b, 0)).toBe(all);
  const counted = await counts();
  await bars.nth(15).click();
  await panel(page).getByText(`${counted[15]} triangles shown.`).waitFor();
  await panel(page).getByRole("button", { name: "Show all" }).click();
  // The one that the input forbids to be better.
  await panel(page).locator(".mesh-unmet button").first().click();
  await panel(page).getByText("The input is the excuse.").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("a number that is none is refused at its field", async () => {
  const page = await visit("lake");
  const edge = panel(page).getByLabel("Longest edge", { exact: true });
  await edge.fill("-1");
  await panel(page).getByText("This must be more than 0.").waitFor();
  await expect.poll(() => edge.getAttribute("aria-invalid")).toBe("true");
  await edge.fill("1,5");
  await expect.poll(() => edge.getAttribute("aria-invalid")).toBe("false");
  await tab(page, "Export");
  await panel(page).getByText("--max-edge 1.5").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("a triangle explains itself, and arrows go to its neighbours", async () => {
  const page = await visit("thesis");
  await panel(page).getByText("More", { exact: true }).click();
  await panel(page).getByLabel("Strategy of the thesis").check();
  await meshIt(page).click();
  await triangles(page);
  const heading = await ask(page, 0.5, 0.4);
  const first = await heading.textContent();
  await panel(page)
    .getByText(/The smallest angle of this triangle is/)
    .waitFor();
  await panel(page)
    .getByText(/Step \d+\./)
    .waitFor();
  await page.keyboard.press("ArrowLeft");
  await heading.filter({ hasNotText: first! }).waitFor();
  await page.keyboard.press("ArrowRight");
  await heading.filter({ hasText: first! }).waitFor();
  await page.keyboard.press("Escape");
  await heading.waitFor({ state: "detached" });
  expect(theatre.complaints).toEqual([]);
});

test("saved files are read again to the same triangles", async () => {
  const page = await visit("coast");
  await page.getByRole("spinbutton", { name: "Segments" }).fill("40");
  await page.getByRole("spinbutton", { name: "Segments" }).press("Enter");
  await page.getByText("Points: 40, segments: 40,").waitFor();
  await panel(page).getByLabel("With segments").check();
  await meshIt(page).click();
  await triangles(page);
  const expected = await hash(page);
  for (const extension of ["vtu", "ele"]) {
    const saved = new Map<string, Uint8Array>();
    page.on("download", async (file) => {
      saved.set(file.suggestedFilename(), readFileSync(await file.path()));
    });
    await panel(page).getByRole("button", { name: "Save the mesh" }).click();
    const dialog = page.getByRole("dialog");
    await dialog.getByLabel("Format").selectOption(extension);
    if (extension === "ele") await dialog.getByLabel("Several files as one .zip").uncheck();
    await dialog.getByRole("button", { name: "Save" }).click();
    await expect.poll(() => saved.size).toBe(extension === "vtu" ? 1 : 5);
    // The file that was asked for comes first: it is the one that is opened.
    const names = [...saved.keys()].sort(
      (a, b) => Number(b.endsWith(extension)) - Number(a.endsWith(extension)),
    );
    const drawing = Drawing.fromFiles(
      names,
      names.map((name) => saved.get(name)!),
    );
    const again = new Set(corners(drawing.points(), drawing.triangles()));
    const made = Mesh.constrain(Drawing.preset("coast", 40, 1));
    expect(made.hash()).toBe(expected);
    expect(again).toEqual(new Set(corners(made.points(), made.triangles())));
    page.removeAllListeners("download");
  }
  expect(theatre.complaints).toEqual([]);
});

/** Names triangles by the places of their corners. */
function corners(points: Float64Array, triangles: Uint32Array): string[] {
  return Array.from({ length: triangles.length / 3 }, (_, t) =>
    [0, 1, 2]
      .map((k) => triangles[3 * t + k])
      .map((v) => `${points[2 * v]} ${points[2 * v + 1]}`)
      .sort()
      .join(", "),
  );
}

test("a million triangles are made and moved about", async () => {
  const page = await visit("uniform");
  await page.getByRole("spinbutton", { name: "Points" }).fill("500000");
  await page.getByRole("spinbutton", { name: "Points" }).press("Enter");
  await panel(page).getByLabel("Delaunay triangulation").check();
  await page.getByText("Points: 500,000,").waitFor();
  await page.keyboard.press("Enter");
  expect(await triangles(page)).toBeGreaterThan(990_000);
  // Its angles matter to others, and not to this kind.
  expect(await panel(page).getByText("Other options are chosen by now.").count()).toBe(0);
  const box = (await page.locator(".stage-view").boundingBox())!;
  await page.mouse.move(box.x + 300, box.y + 300);
  await page.mouse.down();
  const since = performance.now();
  for (let k = 0; k < 5; k++) {
    await page.mouse.move(box.x + 300 + 8 * k, box.y + 300);
    await page.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
  }
  await page.mouse.up();
  console.log(`a million triangles: ${((performance.now() - since) / 5).toFixed(0)} ms a move`);
  await ask(page, 0.5, 0.5);
  await page.getByRole("checkbox", { name: "Voronoi cells", exact: true }).check();
  await page.getByRole("checkbox", { name: "Nearest vertex", exact: true }).check();
  await page.mouse.move(box.x + 320, box.y + 320);
  await page.waitForTimeout(2000);
  const began = performance.now();
  for (let k = 0; k < 5; k++) {
    await page.mouse.move(box.x + 300 + 8 * k, box.y + 310);
    await page.evaluate(() => new Promise((next) => requestAnimationFrame(next)));
  }
  console.log(
    `with its cells and the nearest vertex: ${((performance.now() - began) / 5).toFixed(0)} ms a move`,
  );
  expect(theatre.complaints).toEqual([]);
});
