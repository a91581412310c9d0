// The page as a whole: how soon it is seen, that nothing jumps, what it weighs, that it talks to nobody, and what it
// says where it cannot work.

import { readdirSync, readFileSync } from "node:fs";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, onTestFinished, test } from "vitest";
import { settled, Theatre } from "./page";

const assets = fileURLToPath(new URL("../../dist/assets/", import.meta.url));

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** Returns how many kilobytes the files of some types take on their way. */
function weight(...types: string[]): number {
  const files = readdirSync(assets).filter((name) => types.includes(extname(name)));
  const bytes = files.map((name) => gzipSync(readFileSync(assets + name), { level: 9 }).length);
  return bytes.reduce((sum, each) => sum + each, 0) / 1000;
}

describe("budgets", () => {
  test("scripts and styles take at most 250 kB", () => {
    const kilobytes = weight(".js", ".css");
    console.log(`scripts and styles: ${kilobytes.toFixed(0)} kB`);
    expect(kilobytes).toBeGreaterThan(10);
    expect(kilobytes).toBeLessThanOrEqual(250);
  });
  test("the module takes at most 1500 kB", () => {
    const kilobytes = weight(".wasm");
    console.log(`module: ${kilobytes.toFixed(0)} kB`);
    expect(kilobytes).toBeGreaterThan(100);
    expect(kilobytes).toBeLessThanOrEqual(1500);
  });
});

test.each([
  { width: 1280, height: 720 },
  { width: 800, height: 1100 },
  { width: 390, height: 844 },
])("it is seen at once, and nothing jumps: $width × $height", async (viewport) => {
  let isSeen = () => {};
  const seen = new Promise<void>((done) => {
    isSeen = done;
  });
  const page = await theatre.visit("", { viewport }, async (blank) => {
    await blank.addInitScript(() => {
      const shifts: PerformanceEntry[] = [];
      Object.assign(globalThis, { shifts });
      new PerformanceObserver((list) => shifts.push(...list.getEntries())).observe({ type: "layout-shift" });
    });
    // The module comes late: whoever waited for it would never be seen.
    await blank.route("**/*.wasm", async (route) => {
      await seen;
      await route.continue();
    });
  });
  const paint = await firstPaint(page);
  isSeen();
  await settled(page);
  const shift = await shifts(page);

  // How slow the machine is at the moment a page with a word on it tells.
  const bare = await page.context().newPage();
  await bare.route("**/bare.html", (route) =>
    route.fulfill({ contentType: "text/html", body: "<p>Bare</p>" }),
  );
  await bare.goto(`${theatre.address}bare.html`);
  const least = await firstPaint(bare);
  const told = `first paint ${paint.toFixed(0)} ms, of a bare page ${least.toFixed(0)} ms`;
  console.log(`${told}, shift ${shift.sum.toFixed(4)}`, shift.moved);
  expect(paint).toBeLessThan(Math.max(1500, 20 * least));
  expect(shift.sum).toBeLessThan(0.02);
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
});

/** Waits until there is something to see, and returns when that was, in milliseconds. */
async function firstPaint(page: Page): Promise<number> {
  const time = () =>
    page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? 0);
  await expect.poll(time).toBeGreaterThan(0);
  return time();
}

/** Returns how far things have jumped, and which have: for whoever looks for the cause. */
const shifts = (page: Page): Promise<{ sum: number; moved: string[] }> =>
  page.evaluate(async () => {
    type Shift = PerformanceEntry & { value: number; sources: { node: Element | null }[] };
    const { shifts } = globalThis as unknown as { shifts: Shift[] };
    // The browser tells later, and nothing at all if nothing has jumped: what jumps now is told after all the rest.
    const since = await new Promise(requestAnimationFrame);
    document.body.style.marginTop = "100px";
    while (!shifts.some(({ startTime }) => startTime > since)) await new Promise(requestAnimationFrame);
    const before = shifts.filter(({ startTime }) => startTime <= since);
    return {
      sum: before.reduce((sum, { value }) => sum + value, 0),
      moved: before.flatMap(({ value, sources }) =>
        sources.map(
          ({ node }) =>
            `${value.toFixed(4)} ${node?.parentElement?.className} > ${node?.nodeName} ${node?.id} ${node?.textContent?.slice(0, 30)}`,
        ),
      ),
    };
  });

test("no request leaves its origin", async () => {
  const asked: string[] = [];
  const page = await theatre.visit("", {}, async (blank) => {
    blank.on("request", (request) => asked.push(request.url()));
  });
  await settled(page);
  for (const mode of await page.locator(".modes button").all()) {
    await mode.click();
    await settled(page);
  }
  expect(asked.length).toBeGreaterThan(3);
  expect(asked.filter((url) => !url.startsWith(theatre.address) && !/^(blob|data):/.test(url))).toEqual([]);
  // Nothing from elsewhere could be loaded: the policy of the page says so, and is the server's, too.
  const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  expect(policy).toBe(policyOfServer());
  await page.context().close();
});

/** Returns the policy that `delone theatre` sends, less what only a header may say. */
function policyOfServer(): string {
  const file = new URL("../../../crates/delone-cli/src/theatre/answer.rs", import.meta.url);
  const written = /const POLICY: &str = "([^"]*)"/.exec(readFileSync(file, "utf8"))?.[1] ?? "";
  return written.replace(/\\\n\s*/g, "").replace("; frame-ancestors 'none'", "");
}

test("without WebAssembly, workers or the module it says why it cannot work", async () => {
  for (const [name, reason] of [
    ["WebAssembly", "This browser has no WebAssembly"],
    ["Worker", "This browser has no workers"],
  ]) {
    const page = await theatre.visit("", {}, (blank) => blank.addInitScript(`delete globalThis.${name}`));
    expect(await page.getByRole("alert").textContent()).toContain(reason);
    await page.context().close();
  }
  const other = await Theatre.open();
  onTestFinished(() => other.close());
  const page = await other.visit("", {}, (blank) => blank.route("**/*.wasm", (route) => route.abort()));
  expect(await page.getByRole("alert").textContent()).toContain("could not be started");
  await page.getByRole("button", { name: "Load again" }).waitFor();
  expect(theatre.complaints).toEqual([]);
});
