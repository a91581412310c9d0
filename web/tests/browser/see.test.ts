// Overlays: each can be switched on in the middle of a run and draws; the pointer asks; the lifted view turns.

import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** Opens the page with nothing switched on. */
async function bare(size = { width: 1280, height: 720 }): Promise<Page> {
  const page = await theatre.visit("#see=", { reducedMotion: "reduce", viewport: size });
  await settled(page);
  await page.getByText("Before the first step.").waitFor();
  return page;
}

async function play(page: Page, algorithm: string, preset?: string): Promise<void> {
  if (preset) {
    await page.getByLabel("Preset").selectOption(preset);
    await settled(page);
  }
  await page.getByRole("combobox", { name: "Algorithm" }).selectOption(algorithm);
  await settled(page);
}

/** Goes to a part of the run; who is in a hurry does not wait until all is drawn there. */
async function seek(page: Page, share: number, isHurried = false): Promise<void> {
  await page.getByRole("slider", { name: "Position" }).evaluate((slider: HTMLInputElement, to) => {
    slider.value = String(Math.round(to * Number(slider.max)));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, share);
  if (isHurried) await page.waitForTimeout(30);
  else await settled(page);
}

const canvas = (page: Page): Locator => page.locator(".stage canvas").last();

/** Counts the pixels of a canvas on which something is drawn. */
const drawn = (of: Locator): Promise<number> =>
  of.evaluate((element) => {
    // A copy: who reads a canvas often makes it slow.
    const { width, height } = element as HTMLCanvasElement;
    const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
    copy.drawImage(element as HTMLCanvasElement, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    let count = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 0) count += 1;
    return count;
  });

/** The picture on a canvas. */
const picture = (of: Locator): Promise<string> =>
  of.evaluate((element) => (element as HTMLCanvasElement).toDataURL());

const box = (page: Page, name: string): Locator => page.getByRole("checkbox", { name, exact: true });

/**
 * Switches something on, sees that more is drawn, and switches it off again; by keys if the pointer is to stay where
 * it is.
 */
async function draws(page: Page, name: string, byKeys = false): Promise<void> {
  const toggle = () => (byKeys ? box(page, name).press("Space") : box(page, name).click());
  await settled(page);
  const before = await drawn(canvas(page));
  const now = () => drawn(canvas(page));
  await toggle();
  await expect.poll(now, { message: name }).toBeGreaterThan(before + 20);
  await settled(page);
  await toggle();
  await expect.poll(now, { message: `${name}, off` }).toBe(before);
}

/** Jumps to the next moment of a kind. */
async function jump(page: Page, kind: string): Promise<void> {
  await page.getByRole("combobox", { name: "Jump to" }).selectOption({ label: kind });
  await page.getByRole("button", { name: `Next: ${kind}` }).click();
  await settled(page);
}

/** Goes on, step by step at most so far, until the page says something. */
async function until(page: Page, said: RegExp): Promise<void> {
  const step = page.getByRole("button", { name: "Step", exact: true });
  for (let i = 0; i < 400; i++) {
    if (await page.locator(".narration").filter({ hasText: said }).count()) return;
    await step.click();
    await settled(page);
  }
  throw new Error(`nothing says ${said}`);
}

test("what explains a step can be switched on in the middle of a run", async () => {
  const page = await bare();
  await play(page, "fortune");
  await seek(page, 0.5);
  for (const name of [
    "Marks",
    "Front",
    "Sweep",
    "Stack or queue",
    "Numbers",
    "Voronoi cells",
    "Dual (Voronoi)",
  ]) {
    await draws(page, name);
  }
  await play(page, "cline-renka");
  await seek(page, 0.6);
  await until(page, /walk/i);
  await draws(page, "Walk");
  await play(page, "edge-flip");
  await seek(page, 0.5);
  await until(page, /circle/i);
  await draws(page, "Circle test");
  expect(theatre.complaints).toEqual([]);
});

test("what some algorithms have of their own is drawn", async () => {
  const page = await bare();
  await play(page, "printed-sweep", "thesis");
  await seek(page, 0.5);
  await until(page, /see/i);
  await draws(page, "Rays");
  await draws(page, "Diametral circles");
  await play(page, "algorithm-a", "uniform");
  await seek(page, 0.9);
  await draws(page, "Data");
  await seek(page, 0.7);
  await draws(page, "Clusters");
  expect(theatre.complaints).toEqual([]);
});

test("refinement shows what is encroached upon, and how angles become better", async () => {
  const page = await bare();
  await play(page, "refinement", "lake");
  await page.getByLabel("Smallest angle, degrees").fill("33");
  await page.getByLabel("Smallest angle, degrees").press("Enter");
  await settled(page);
  // The domain is laid out first, and takes thousands of steps.
  await jump(page, "end of a stage");
  await until(page, /too close/);
  await draws(page, "Encroachment");
  await draws(page, "Diametral circles");
  await until(page, /rejected/);
  await draws(page, "Encroachment");
  const small = async () =>
    Number(/, (\d+) of them/.exec((await page.locator(".angles figcaption").textContent()) ?? "")?.[1]);
  await expect.poll(small).toBeGreaterThan(0);
  const before = await small();
  await seek(page, 1);
  await expect.poll(small).toBeLessThan(before);
  await page.screenshot({ path: "test-results/see-refinement.png" });
  expect(theatre.complaints).toEqual([]);
});

test("a race has no switches, and none of what they switch", async () => {
  const page = await bare();
  for (const each of await page.locator(".see").getByRole("checkbox").all()) await each.check();
  await page.getByRole("button", { name: "Race", exact: true }).click();
  await page.locator(".lane").first().waitFor();
  await expect.poll(() => page.locator(".see").count()).toBe(0);
  const sheet = page.locator(".lane .stage canvas").last();
  await sheet.hover();
  await settled(page);
  expect(await drawn(sheet), "before the start").toBe(0);
  expect(theatre.complaints).toEqual([]);
});

test("edges are judged", async () => {
  const page = await bare();
  await play(page, "flip-list", "grid");
  await seek(page, 0.4);
  await draws(page, "Cocircular");
  await draws(page, "Illegal edges");
  await seek(page, 1);
  await draws(page, "Cocircular");
  await box(page, "Illegal edges").check();
  await settled(page);
  expect(await drawn(canvas(page)), "a finished triangulation").toBe(0);
  expect(theatre.complaints).toEqual([]);
});

test("the pointer asks for half-edges, vertices and triangles", async () => {
  const page = await bare();
  await play(page, "incremental");
  await seek(page, 1);
  await canvas(page).hover();
  for (const name of ["Half-edges", "Nearest vertex", "Triangle"]) {
    await box(page, name).focus();
    const place = (await canvas(page).boundingBox())!;
    await page.mouse.move(place.x + place.width * 0.4, place.y + place.height * 0.5);
    await settled(page);
    const before = await drawn(canvas(page));
    await page.keyboard.press("Space");
    await expect.poll(() => drawn(canvas(page)), { message: name }).toBeGreaterThan(before + 20);
    await settled(page);
    const first = await picture(canvas(page));
    await page.mouse.move(place.x + place.width * 0.6, place.y + place.height * 0.4);
    await settled(page);
    await expect.poll(() => picture(canvas(page)), { message: `${name}, elsewhere` }).not.toBe(first);
    await page.keyboard.press("Space");
  }
  expect(theatre.complaints).toEqual([]);
});

test("a mesh has overlays too", async () => {
  const page = await bare();
  await page.getByLabel("Preset").selectOption("gear");
  await page.getByRole("button", { name: "Mesh", exact: true }).first().click();
  await page.getByRole("button", { name: "Mesh it" }).click();
  await page.locator(".mesh-outcome").waitFor();
  for (const name of ["Voronoi cells", "Dual (Voronoi)", "Diametral circles"]) await draws(page, name);
  // In the middle there is a hole.
  const place = (await canvas(page).boundingBox())!;
  const point = (share: number) =>
    page.mouse.move(place.x + place.width / 2 + share * place.height, place.y + place.height / 2);
  await point(0.25);
  for (const name of ["Nearest vertex", "Half-edges", "Triangle"]) await draws(page, name, true);
  await box(page, "Voronoi cells").check();
  await box(page, "Nearest vertex").check();
  await point(0.3);
  await settled(page);
  await page.screenshot({ path: "test-results/see-mesh.png" });
  expect(theatre.complaints).toEqual([]);
});

test("the lifted view rises, turns by keys and by hand, and is closed", async () => {
  const page = await bare();
  await play(page, "flip-list");
  await seek(page, 0.5);
  await page.getByRole("button", { name: "Lifted view" }).click();
  const view = page.getByRole("application", { name: /paraboloid/ });
  const sheet = view.locator("canvas");
  await settled(page);
  const pictures = [await picture(sheet)];
  await view.focus();
  await page.keyboard.press("ArrowRight");
  await settled(page);
  pictures.push(await picture(sheet));
  const place = (await view.boundingBox())!;
  await page.mouse.move(place.x + 100, place.y + 200);
  await page.mouse.down();
  await page.mouse.move(place.x + 180, place.y + 240, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  pictures.push(await picture(sheet));
  await page.getByRole("slider", { name: "Height" }).fill("0.3");
  await settled(page);
  pictures.push(await picture(sheet));
  await seek(page, 0.9);
  pictures.push(await picture(sheet));
  expect(new Set(pictures).size).toBe(pictures.length);
  await page.screenshot({ path: "test-results/lift.png" });
  await page.getByRole("button", { name: "Close the lifted view" }).click();
  await expect.poll(() => view.count()).toBe(0);
  expect(theatre.complaints).toEqual([]);
});

test("what is switched is kept, and set back", async () => {
  const page = await theatre.visit();
  await page.getByText("Before the first step.").waitFor();
  await expect.poll(() => box(page, "Front").isChecked()).toBe(true);
  await box(page, "Front").uncheck();
  await box(page, "Voronoi cells").check();
  // The address follows later, and counts for more than what is kept.
  await expect.poll(() => page.url()).toMatch(/see=(?!.*front).*voronoi/);
  await page.reload();
  await page.getByText("Before the first step.").waitFor();
  await expect.poll(() => box(page, "Front").isChecked()).toBe(false);
  await expect.poll(() => box(page, "Voronoi cells").isChecked()).toBe(true);
  await page.getByRole("button", { name: "As usual" }).click();
  await expect.poll(() => box(page, "Front").isChecked()).toBe(true);
  await expect.poll(() => box(page, "Voronoi cells").isChecked()).toBe(false);
  expect(theatre.complaints).toEqual([]);
});

test("everything at once is drawn while any algorithm plays", async () => {
  const page = await bare();
  for (const each of await page.locator(".see").getByRole("checkbox").all()) await each.check();
  await page.getByRole("button", { name: "Lifted view" }).click();
  const place = (await canvas(page).boundingBox())!;
  for (const preset of ["grid", "thesis"]) {
    await page.getByLabel("Preset").selectOption(preset);
    await settled(page);
    const choice = page.getByRole("combobox", { name: "Algorithm" });
    const names = await choice
      .locator("option")
      .evaluateAll((all) => all.map((each) => (each as HTMLOptionElement).value));
    for (const name of names) {
      await choice.selectOption(name);
      await page.mouse.move(place.x + place.width * 0.4, place.y + place.height * 0.5);
      for (const share of [0.02, 0.3, 0.31, 0.8, 1]) await seek(page, share, true);
      await page.mouse.move(place.x + place.width * 0.6, place.y + place.height * 0.4);
      await settled(page);
    }
  }
  expect(await page.locator(".notice").allTextContents()).toEqual([]);
  expect(theatre.complaints).toEqual([]);
});

test("all fits on a telephone", async () => {
  const page = await bare({ width: 360, height: 780 });
  await page.getByRole("button", { name: "See", exact: true }).click();
  await page.getByRole("button", { name: "Lifted view" }).click();
  await settled(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(360);
  expect(theatre.complaints).toEqual([]);
});
