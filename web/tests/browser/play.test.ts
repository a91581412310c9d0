// Playing: to the end and back, backwards, with breakpoints.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const slider = (page: Page) => page.getByRole("slider", { name: "Position" });
const at = async (page: Page) => Number(await slider(page).inputValue());
const end = async (page: Page) => Number(await slider(page).getAttribute("max"));

/** Opens the page with a run of flips on the stage. */
async function open(): Promise<Page> {
  const page = await theatre.visit();
  await page.getByRole("combobox", { name: "Algorithm" }).selectOption("flip-list");
  // As long as there is no run at all, the code of the one that is to come is shown.
  await expect.poll(() => end(page)).toBeGreaterThan(0);
  await page.getByText("while an edge e can be popped").waitFor();
  await page.getByText("Before the first step.").waitFor();
  return page;
}

/** Moves the speed as far as it goes. */
async function hurry(page: Page): Promise<void> {
  await page.getByRole("slider", { name: "Speed" }).press("End");
  await page.getByText("as fast as it goes").waitFor();
}

const playing = (page: Page) => page.getByRole("region", { name: "Playing" });
const play = (page: Page) => playing(page).getByRole("button", { name: "Play", exact: true });
const paused = (page: Page) => play(page).waitFor();
const isAtEnd = (page: Page) => expect.poll(async () => (await at(page)) - (await end(page))).toBe(0);

test("a run is played to its end, scrubbed back, and stepped", async () => {
  const page = await open();
  await hurry(page);
  await play(page).click();
  await page.getByText("This was the last step.").waitFor();
  await isAtEnd(page);
  await page.screenshot({ path: "test-results/play.png" });
  await slider(page).fill("400");
  await page.getByText("400 of").waitFor();
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => at(page)).toBe(401);
  await page.keyboard.press("Home");
  await page.getByText("Before the first step.").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("keys step, and jump from flip to flip in both directions", async () => {
  const page = await open();
  await page.keyboard.press("f");
  const said = page.locator(".narration p").first();
  await expect.poll(() => said.textContent()).toContain("is flipped");
  const first = await at(page);
  await page.keyboard.press("f");
  await expect.poll(() => at(page)).toBeGreaterThan(first);
  await page.keyboard.press("Shift+F");
  await expect.poll(() => at(page)).toBe(first);
  await expect.poll(() => said.textContent()).toContain("is flipped");
  // A flip backwards: the step before it is the test that asked for it.
  await page.keyboard.press("ArrowLeft");
  await expect.poll(() => said.textContent()).toContain("lies inside the circle");
  await expect.poll(() => at(page)).toBe(first - 1);
  expect(theatre.complaints).toEqual([]);
});

test("a run plays backwards to its beginning", async () => {
  const page = await open();
  await hurry(page);
  await page.getByRole("button", { name: "To the end" }).click();
  await page.getByText("This was the last step.").waitFor();
  await page.getByRole("button", { name: "Play backwards" }).click();
  await page.getByText("Before the first step.").waitFor();
  await paused(page);
  await expect.poll(() => at(page)).toBe(0);
  expect(theatre.complaints).toEqual([]);
});

test("a breakpoint on a line stops there, every time it begins to run", async () => {
  const page = await open();
  await hurry(page);
  await page.getByTitle("Breakpoint on line 4").click();
  await play(page).click();
  await page.getByText("Stopped: line 4 runs").waitFor();
  await paused(page);
  const first = await at(page);
  await expect.poll(() => page.locator('.code [aria-current="step"]').textContent()).toContain("flip(e)");
  await page.keyboard.press("b");
  await expect.poll(() => at(page)).toBeGreaterThan(first);
  await page.keyboard.press("Shift+B");
  await expect.poll(() => at(page)).toBe(first);
  // Once it is gone, nothing stops.
  await page.getByTitle("Breakpoint on line 4").click();
  await play(page).click();
  await page.getByText("This was the last step.").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("playing stops once there are fewer conflicts", async () => {
  const page = await open();
  await hurry(page);
  await page.getByText("Breakpoints", { exact: true }).click();
  await page.getByRole("combobox", { name: "Stop" }).selectOption("conflicts");
  await page.getByRole("spinbutton", { name: "Conflicts" }).fill("100");
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await play(page).click();
  await page.getByText("Stopped: Conflicts Φ is below 100").waitFor();
  await paused(page);
  const chart = page.getByRole("img", { name: /Conflicts Φ/ });
  const here = async () => Number((await chart.getAttribute("aria-label"))?.match(/Φ: (\d+) here/)?.[1]);
  await expect.poll(here).toBeLessThan(100);
  await expect.poll(here).toBeGreaterThan(0);
  expect(theatre.complaints).toEqual([]);
});

test("figures are those of the position, and the result is the library's", async () => {
  const page = await open();
  await page.getByText("Figures", { exact: true }).click();
  const steps = page.getByRole("row", { name: /^Steps/ }).getByRole("cell");
  await expect.poll(() => steps.first().textContent()).toBe("0");
  await page.keyboard.press("End");
  const left = async () => {
    const [here, total] = await steps.allTextContents();
    return here === total ? 0 : `${here} of ${total}`;
  };
  await expect.poll(left).toBe(0);
  await page.getByText("the library's triangulation").waitFor();
  await page.getByText("Smallest angles", { exact: true }).click();
  const angles = page.getByRole("img", { name: /triangles, .* below 20°/ });
  await expect
    .poll(async () => Number.parseInt((await angles.getAttribute("aria-label")) ?? "", 10))
    .toBeGreaterThan(40);
  expect(theatre.complaints).toEqual([]);
});

test("while a seed is turned, the run stays at its end", async () => {
  const page = await theatre.visit();
  await page.getByRole("combobox", { name: "Algorithm" }).selectOption("random-incremental");
  await page.locator(".code").getByText("shuffle").waitFor();
  await page.keyboard.press("End");
  await page.getByText("This was the last step.").waitFor();
  const before = await end(page);
  await page.getByRole("button", { name: "Another seed" }).last().click();
  await expect.poll(() => end(page)).not.toBe(before);
  await page.getByText("This was the last step.").waitFor();
  await isAtEnd(page);
  // Another drawing begins at its beginning.
  await page.getByRole("combobox", { name: "Preset" }).selectOption("grid");
  await page.getByText("Before the first step.").waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("what is pressed while another run is made is meant for that", async () => {
  const page = await open();
  /** Chooses something, and presses keys at once, or when the run before is given up. */
  const choose = (label: string, value: string, keys: string[], isLate = false) =>
    page.getByRole("combobox", { name: label, exact: true }).evaluate(
      async (select: HTMLSelectElement, told) => {
        select.value = told.value;
        select.dispatchEvent(new Event("change", { bubbles: true }));
        if (told.isLate) await new Promise((next) => setTimeout(next));
        for (const key of told.keys)
          document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
      },
      { value, keys, isLate },
    );
  const isOver = async (text: string) => {
    await page.locator(".code").getByText(text).waitFor();
    await page.getByText("This was the last step.").waitFor();
    await isAtEnd(page);
  };
  await choose("Algorithm", "random-incremental", ["End"]);
  await isOver("shuffle");
  await choose("Algorithm", "flip-list", ["End"], true);
  await isOver("while an edge e can be popped");
  const before = await end(page);
  await choose("Preset", "grid", ["End"]);
  await expect.poll(() => end(page)).not.toBe(before);
  await isOver("while an edge e can be popped");
  // One after the other.
  await choose("Algorithm", "random-incremental", ["End", "Home", "ArrowRight", "ArrowRight"]);
  await page.locator(".code").getByText("shuffle").waitFor();
  await expect.poll(() => at(page)).toBe(2);
  await choose("Algorithm", "flip-list", [" "]);
  await page.getByText("while an edge e can be popped").waitFor();
  await expect.poll(() => at(page)).toBeGreaterThan(2);
  await playing(page).getByRole("button", { name: "Pause", exact: true }).waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("in German, algorithms are described and steps are named in German", async () => {
  const page = await theatre.visit("", { locale: "de" });
  const choice = page.getByRole("combobox", { name: "Algorithmus" });
  for (const name of ["constrained", "refinement"]) {
    await choice.selectOption(name);
    const about = page.locator(".work details").filter({ hasText: "Beschreibung" });
    await expect.poll(() => about.locator("a").getAttribute("href")).toBe(`guide/${name}.html`);
    expect(await about.locator("dl").getAttribute("lang")).toBeNull();
  }
  await page.getByText("Vor dem ersten Schritt.").waitFor();
  await page.getByRole("button", { name: "Schritt", exact: true }).click();
  await page
    .locator(".narration-note")
    .filter({ hasText: /(Ecke|Kante|Dreieck) entsteht/ })
    .waitFor();
  expect(theatre.complaints).toEqual([]);
});
