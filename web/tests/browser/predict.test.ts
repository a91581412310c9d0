// The guessing game, by keyboard and by pointer.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const question = "Which of the three is flipped next?";

async function open(algorithm: string): Promise<Page> {
  const page = await theatre.visit();
  await page.getByRole("combobox", { name: "Algorithm" }).selectOption(algorithm);
  // Its run is there: a puzzle of the one before would give way to that of this one.
  await settled(page);
  await page.getByRole("button", { name: "Predict" }).click();
  return page;
}

const verdict = (page: Page) => page.locator(".verdict");

/** The numbers of the score: right, asked. */
const points = async (page: Page) =>
  (await page.locator(".score dd").first().textContent())?.split("/").map(Number);

test("flips are guessed by keyboard", async () => {
  const page = await open("flip-list");
  let right = 0;
  for (let round = 1; round <= 4; round++) {
    await page.getByText(question).waitFor();
    await page.keyboard.press(String(1 + (round % 3)));
    await verdict(page).waitFor();
    if ((await verdict(page).textContent()) === "Right!") right += 1;
    await page.getByText(/Edge \d+–\d+ is flipped to/).waitFor();
    await expect.poll(() => points(page)).toEqual([right, round]);
    await page.keyboard.press("Enter");
  }
  await page.getByText(question).waitFor();
  await page.keyboard.press("h");
  const hint = page.getByRole("button", { name: "Hint" });
  await expect.poll(() => hint.getAttribute("aria-pressed")).toBe("true");
  await page.screenshot({ path: "test-results/predict.png" });
  expect(theatre.complaints).toEqual([]);
});

test("exactly one of the three is right", async () => {
  let right = 0;
  for (const key of ["1", "2", "3"]) {
    const page = await open("flip-list");
    await page.getByText(question).waitFor();
    await page.keyboard.press(key);
    await verdict(page).waitFor();
    if ((await verdict(page).textContent()) === "Right!") right += 1;
    await page.context().close();
  }
  expect(right).toBe(1);
  expect(theatre.complaints).toEqual([]);
});

test("a sweep flips for dents: the reason is its own test, and no edge must go for its circle", async () => {
  const page = await open("sweep");
  for (let round = 0; round < 3; round++) {
    await page.getByText(question).waitFor();
    await page.keyboard.press("1");
    await verdict(page).waitFor();
    await page.getByText("Here that decides, not the circle.").waitFor();
    expect(await page.locator(".predict-message").textContent()).not.toMatch(/locally Delaunay|must go/);
    await page.keyboard.press("Enter");
  }
  expect(theatre.complaints).toEqual([]);
});

test("whoever presses Enter on seeing the verdict is asked the next question", async () => {
  const page = await open("sweep");
  await page.getByText(question).waitFor();
  // Sooner than any eye: as soon as the verdict is part of the page.
  await page.evaluate(() => {
    const observer = new MutationObserver(() => {
      if (!document.querySelector(".verdict")) return;
      observer.disconnect();
      (document.activeElement as HTMLElement).click();
    });
    observer.observe(document.body, { childList: true, subtree: true });
  });
  await page.keyboard.press("1");
  await expect.poll(() => points(page)).toEqual([expect.any(Number), 1]);
  await page.getByText(question).waitFor();
  await expect.poll(() => verdict(page).count()).toBe(0);
  expect(theatre.complaints).toEqual([]);
});

test("any edge may be guessed, with the arrow keys or on the stage", async () => {
  const page = await open("greedy-flips");
  await page.getByRole("radio", { name: "any edge" }).check();
  await page.getByText("Which edge is flipped next?").waitFor();
  await page.locator(".predict-bar").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await verdict(page).waitFor();
  await page.keyboard.press("Enter");
  await page.getByText("Which edge is flipped next?").waitFor();
  // Somewhere in the middle an edge is near.
  const box = (await page.locator("#stage .stage").boundingBox())!;
  for (let x = 0.4; x < 0.6 && (await verdict(page).count()) === 0; x += 0.02) {
    await page.mouse.click(box.x + x * box.width, box.y + 0.5 * box.height);
    await settled(page);
  }
  await verdict(page).waitFor();
  await expect.poll(() => points(page)).toEqual([expect.any(Number), 2]);
  expect(theatre.complaints).toEqual([]);
});

test("who makes no flips offers others", async () => {
  const page = await open("divide-and-conquer");
  await page.getByText("This algorithm makes no flips here.").first().waitFor();
  await page.getByRole("button", { name: "Greedy flips with a work list" }).click();
  await page.getByText(question).waitFor();
  expect(theatre.complaints).toEqual([]);
});
