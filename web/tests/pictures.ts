// The pictures of `docs/theatre.md`: `npm run build && npm run pictures`. Fixed sizes, fixed drawings, places in runs that
// are found by what happens there, names as people read them: so that a picture changes only when the page does.

import { mkdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./browser/page";

const folder = fileURLToPath(new URL("../../docs/theatre/", import.meta.url));

/** The most bytes that a picture may take in the repository. */
const MOST = 250_000;

const large = { width: 1200, height: 740 };
const phone = { width: 390, height: 844 };

let theatre: Theatre;
beforeAll(async () => {
  mkdirSync(folder, { recursive: true });
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

interface Look {
  viewport?: { width: number; height: number };
  colorScheme?: "light" | "dark";
}

/** Opens a link, as somebody sees it who has been here before. */
async function visit(hash: string, look: Look = {}): Promise<Page> {
  const options = { viewport: large, colorScheme: "light", reducedMotion: "reduce", ...look } as const;
  const page = await theatre.visit(`#${hash}`, options, (blank) =>
    blank.addInitScript(() => localStorage.setItem("delone.first", "dismissed")),
  );
  await page.locator(".loading").waitFor({ state: "detached" });
  return page;
}

/** Goes to the next moments of a kind, by the key for it. */
async function jump(page: Page, key: string, times: number): Promise<void> {
  const position = page.getByLabel("Position", { exact: true });
  await expect.poll(() => position.getAttribute("max"), { timeout: 20_000 }).not.toBe("0");
  for (let i = 0; i < times; i++) {
    const before = await position.inputValue();
    await page.keyboard.press(key);
    await expect.poll(() => position.inputValue(), { timeout: 20_000 }).not.toBe(before);
  }
}

/** Takes the picture once all has come to rest: two pictures in a row are the same. */
async function picture(page: Page, name: string): Promise<void> {
  await page.mouse.move(0, 0);
  let last: Buffer = Buffer.alloc(0);
  await expect
    .poll(
      async () => {
        const before = last;
        last = await page.screenshot({ animations: "disabled", caret: "hide" });
        return last.equals(before);
      },
      { timeout: 20_000, interval: 300 },
    )
    .toBe(true);
  console.log(`${name}.png: ${(last.length / 1000).toFixed(0)} kB`);
  expect(last.length, `${name}.png`).toBeLessThanOrEqual(MOST);
  writeFileSync(`${folder}${name}.png`, last);
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
}

const within = async (stage: Locator, x: number, y: number): Promise<[number, number]> => {
  const box = (await stage.boundingBox())!;
  return [box.x + x * box.width, box.y + y * box.height];
};

test("playing", async () => {
  const page = await visit("preset=uniform&n=40&seed=3&algorithm=incremental&see=marks,circle,walk,waiting");
  await jump(page, "f", 24);
  await picture(page, "play");
});

test("playing in the dark", async () => {
  const page = await visit("preset=uniform&n=40&seed=3&algorithm=fortune&see=marks,circle,front,sweep", {
    colorScheme: "dark",
  });
  await jump(page, "t", 24);
  await picture(page, "dark");
});

test("predicting", async () => {
  const page = await visit("preset=uniform&n=25&seed=5&algorithm=incremental");
  await jump(page, "f", 24);
  await page.getByRole("button", { name: "Predict", exact: true }).click();
  const edges = page.getByRole("group", { name: "Edges to choose from" }).getByRole("button");
  await expect.poll(() => edges.count(), { timeout: 20_000 }).toBe(3);
  await edges.first().click();
  await page.getByRole("button", { name: "Next puzzle" }).waitFor();
  await picture(page, "predict");
});

test("racing", async () => {
  const page = await visit("mode=race&preset=uniform&n=60&seed=3");
  const slider = page.getByRole("slider", { name: "How far the race is" });
  await expect.poll(() => slider.isEnabled()).toBe(true);
  await slider.fill("420");
  await slider.blur();
  await picture(page, "race");
});

test("lifting", async () => {
  const page = await visit("preset=uniform&n=25&seed=3&algorithm=edge-flip&see=marks,illegal");
  await jump(page, "f", 6);
  await page.getByRole("button", { name: "Lifted view" }).click();
  await page.getByText("bend the wrong way").first().waitFor();
  await page.locator(".side .scroll").evaluate((side) => side.scrollTo(0, 0));
  await picture(page, "lift");
});

test("meshing", async () => {
  const page = await visit("mode=mesh&preset=lake&mesh.minAngle=20");
  await page.getByRole("button", { name: "Mesh it" }).click();
  await page.getByRole("tab", { name: "Quality" }).click();
  await page.getByLabel("Colour triangles by it").check();
  const stage = page.getByRole("application");
  await page.mouse.click(...(await within(stage, 0.42, 0.55)));
  await page.getByRole("heading", { name: /^Triangle \d/ }).waitFor();
  await picture(page, "mesh");
});

test("on a phone", async () => {
  const page = await visit("preset=uniform&n=40&seed=3&algorithm=sweep&see=marks,circle,front,sweep", {
    viewport: phone,
  });
  await jump(page, "i", 24);
  await picture(page, "phone");
});
