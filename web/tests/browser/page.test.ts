// The page as a whole: how soon it is seen, that nothing jumps, what it weighs, that it talks to nobody, and what it
// says where it cannot work.

import { readdirSync, readFileSync } from "node:fs";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { Theatre } from "./page";

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
  const page = await theatre.visit("", { viewport });
  await page.locator(".loading").waitFor({ state: "detached" });
  await page.waitForTimeout(700);
  const { paint, shift } = await page.evaluate(async () => {
    const told = <Entry>(type: string) =>
      new Promise<Entry[]>((resolve) => {
        const entries: Entry[] = [];
        new PerformanceObserver((list) => entries.push(...(list.getEntries() as Entry[]))).observe({
          type,
          buffered: true,
        });
        setTimeout(() => resolve(entries), 100);
      });
    const paints = await told<PerformanceEntry>("paint");
    const shifts = await told<{ value: number; sources: { node: Element | null }[] }>("layout-shift");
    return {
      paint: paints.find(({ name }) => name === "first-contentful-paint")?.startTime ?? Number.NaN,
      shift: {
        sum: shifts.reduce((sum, { value }) => sum + value, 0),
        // Who has moved, for whoever looks for the cause.
        moved: shifts.flatMap(({ value, sources }) =>
          sources.map(
            ({ node }) =>
              `${value.toFixed(4)} ${node?.parentElement?.className} > ${node?.nodeName} ${node?.id} ${node?.textContent?.slice(0, 30)}`,
          ),
        ),
      },
    };
  });
  console.log(`first paint ${paint.toFixed(0)} ms, shift ${shift.sum.toFixed(4)}`, shift.moved);
  expect(paint).toBeLessThan(1500);
  expect(shift.sum).toBeLessThan(0.02);
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
});

test("no request leaves its origin", async () => {
  const asked: string[] = [];
  const page = await theatre.visit("", {}, async (blank) => {
    blank.on("request", (request) => asked.push(request.url()));
  });
  await page.locator(".loading").waitFor({ state: "detached" });
  for (const mode of await page.locator(".modes button").all()) await mode.click();
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
  const page = await other.visit("", {}, (blank) => blank.route("**/*.wasm", (route) => route.abort()));
  expect(await page.getByRole("alert").textContent()).toContain("could not be started");
  await page.getByRole("button", { name: "Load again" }).waitFor();
  await other.close();
  expect(theatre.complaints).toEqual([]);
});
