// The stage: two renderers that look alike, exact at any zoom; keys, fingers, pictures.

import { fileURLToPath } from "node:url";
import type { Browser, Page } from "playwright-core";
import { createServer, type ViteDevServer } from "vite";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type Camera, toScreen } from "../../src/stage/camera";
import { settled, Theatre } from "./page";
import { GAP, PLACE } from "./rig/scenes";

const size = { width: 800, height: 600 };

let theatre: Theatre;
let server: ViteDevServer;
beforeAll(async () => {
  theatre = await Theatre.open();
  const root = fileURLToPath(new URL("../..", import.meta.url));
  server = await createServer({
    root,
    server: { host: "127.0.0.1", port: 0 },
    logLevel: "error",
    // Found only when the page is opened otherwise, which is then loaded again in the middle of a test.
    optimizeDeps: {
      include: ["preact", "preact/hooks", "preact/jsx-runtime", "preact/jsx-dev-runtime", "@preact/signals"],
    },
  });
  await server.listen();
});
afterAll(async () => {
  await server.close();
  await theatre.close();
});

/** Opens a stage alone, with a scene of the rig. */
async function rig(query: string, options: Parameters<Browser["newContext"]>[0] = {}): Promise<Page> {
  const page = await theatre.visit(`${server.resolvedUrls!.local[0]}tests/browser/rig/?${query}`, {
    viewport: { width: 900, height: 700 },
    reducedMotion: "reduce",
    ...options,
  });
  await page.locator("#rig[data-camera]").waitFor();
  await settle(page);
  return page;
}

/** Waits until everything is drawn. */
const settle = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    for (let k = 0; k < 4; k++) await new Promise((done) => requestAnimationFrame(done));
  });

const cameraOf = async (page: Page): Promise<Camera> =>
  JSON.parse((await page.locator("#rig").getAttribute("data-camera"))!);

const rendererOf = (page: Page): Promise<string | null> =>
  page.locator("canvas[data-renderer]").getAttribute("data-renderer");

/** What is seen of the stage: four bytes a pixel. */
async function pixels(page: Page): Promise<Uint8Array> {
  const shot = await page.screenshot({ clip: { x: 0, y: 0, ...size } });
  const seen = await page.evaluate(async (bytes) => {
    const image = new Image();
    image.src = `data:image/png;base64,${bytes}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width: image.naturalWidth, height: image.naturalHeight });
    const context = canvas.getContext("2d", { willReadFrequently: true })!;
    context.drawImage(image, 0, 0);
    // Numbers one by one would take their time.
    const rows = Array.from({ length: canvas.height }, (_, y) =>
      String.fromCharCode(...context.getImageData(0, y, canvas.width, 1).data),
    );
    return btoa(rows.join(""));
  }, shot.toString("base64"));
  return Buffer.from(seen, "base64");
}

/** The part of all numbers that clearly differ. */
const differing = (a: Uint8Array, b: Uint8Array): number =>
  a.filter((part, k) => Math.abs(part - b[k]) > 48).length / a.length;

/** The middle of what is dark, also in blue, within some pixels of a place: of all there is only dots are. */
function dotNear(seen: Uint8Array, [x, y]: readonly [number, number]): [number, number] {
  let [count, sumX, sumY] = [0, 0, 0];
  for (let py = Math.round(y) - 6; py < y + 6; py++) {
    for (let px = Math.round(x) - 6; px < x + 6; px++) {
      const at = 4 * (py * size.width + px);
      const dark = Math.max(0, 100 - seen[at + 2]);
      [count, sumX, sumY] = [count + dark, sumX + dark * (px + 0.5), sumY + dark * (py + 0.5)];
    }
  }
  expect(count).toBeGreaterThan(0);
  return [sumX / count, sumY / count];
}

async function wheel(page: Page, [x, y]: readonly [number, number], factor: number): Promise<void> {
  const { scale } = await cameraOf(page);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -Math.log(factor) / 0.0015);
  // Playwright does not wait until the page has heard of it. There is an end to zooming: it need not be the whole factor.
  if (factor > 1) await expect.poll(async () => (await cameraOf(page)).scale / scale).toBeGreaterThan(1.5);
  await settle(page);
}

/** Moves the view, and the pointer out of the way. */
async function drag(page: Page, x: number, y: number): Promise<void> {
  await page.mouse.move(400, 300);
  await page.mouse.down();
  await page.mouse.move(400 + x, 300 + y);
  await page.mouse.up();
  await page.mouse.move(750, 590);
  await settle(page);
}

/** Whether a dot is seen there, with some paper around it and no button over it. */
const isInView = ([x, y]: readonly [number, number]): boolean => x > 10 && x < 750 && y > 10 && y < 560;

test.each(["", "&plain"])("at any zoom points are where they belong%s", async (query) => {
  const page = await rig(`scene=utm${query}`);
  expect(await rendererOf(page)).toBe(query ? "plain" : "webgl");
  const other = [PLACE[0] + 64 * GAP, PLACE[1]] as const;
  let count = 0;
  for (const factor of [1, 100, 100, 100, 100, 10, 3]) {
    const [x, y] = toScreen(await cameraOf(page), size, ...PLACE);
    await wheel(page, [Math.round(x), Math.round(y)], factor);
    for (const step of [0, 37, 23]) {
      await drag(page, step, -step);
      const camera = await cameraOf(page);
      const seen = await pixels(page);
      for (const place of [PLACE, other]) {
        const expected = toScreen(camera, size, ...place);
        // Two dots next to each other pull at each other's middle.
        const gap = camera.scale * 64 * GAP;
        if ((gap > 0.2 && gap < 16) || !isInView(expected)) continue;
        count += 1;
        const [px, py] = dotNear(seen, expected);
        expect(Math.hypot(px - expected[0], py - expected[1])).toBeLessThan(0.8);
      }
    }
    await drag(page, -60, 60);
  }
  expect(count).toBeGreaterThan(20);
  await page.screenshot({ path: `test-results/stage-deep${query}.png` });
  expect((await cameraOf(page)).scale).toBeGreaterThan(1e9);
  expect(theatre.complaints).toEqual([]);
});

test.each(["values", "utm", "huge", "small"])("both renderers look alike: %s", async (scene) => {
  const [one, other] = [await rig(`scene=${scene}`), await rig(`scene=${scene}&plain`)];
  const [a, b] = [await pixels(one), await pixels(other)];
  const share = differing(a, b);
  expect(share).toBeLessThan(0.004);
  // And there is something to see.
  expect(new Set(a).size).toBeGreaterThan(20);
  await one.screenshot({ path: `test-results/stage-${scene}.png` });
  await other.screenshot({ path: `test-results/stage-${scene}-plain.png` });
  expect(theatre.complaints).toEqual([]);
});

test("a context that is lost comes back, or an ordinary canvas takes over", async () => {
  const page = await rig("scene=values");
  const before = await pixels(page);
  const lose = (thenRestore: boolean) =>
    page.evaluate(async (isBack) => {
      const gl = document.querySelector<HTMLCanvasElement>("canvas[data-renderer]")!.getContext("webgl2")!;
      const extension = gl.getExtension("WEBGL_lose_context")!;
      const told = (name: string) => new Promise((done) => gl.canvas.addEventListener(name, done));
      const lost = told("webglcontextlost");
      extension.loseContext();
      await lost;
      if (!isBack) return;
      const restored = told("webglcontextrestored");
      // Not within the event itself.
      await new Promise((next) => setTimeout(next));
      extension.restoreContext();
      await restored;
    }, thenRestore);
  await lose(true);
  await settle(page);
  expect(await rendererOf(page)).toBe("webgl");
  expect(differing(before, await pixels(page))).toBe(0);
  await lose(false);
  await page.locator("canvas[data-renderer=plain]").waitFor();
  await settle(page);
  const after = await pixels(page);
  expect(differing(before, after)).toBeLessThan(0.004);
  // Chromium says that a context was lost.
  theatre.complaints.splice(0);
});

test("keys move the view while the stage has the focus", async () => {
  const page = await rig("scene=utm");
  const start = await cameraOf(page);
  await page.getByRole("application").focus();
  await page.keyboard.press("ArrowRight");
  await expect.poll(async () => (await cameraOf(page)).x).toBeGreaterThan(start.x);
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("+");
  await expect.poll(async () => (await cameraOf(page)).y).toBeGreaterThan(start.y);
  await expect.poll(async () => (await cameraOf(page)).scale).toBeCloseTo(1.5 * start.scale);
  await page.keyboard.press("0");
  await expect.poll(() => cameraOf(page)).toEqual(start);
  expect(theatre.complaints).toEqual([]);
});

test("a double click zooms around the pointer; flights end where they should", async () => {
  const page = await rig("scene=utm", { reducedMotion: "no-preference" });
  const start = await cameraOf(page);
  await page.mouse.dblclick(200, 150);
  await expect.poll(async () => (await cameraOf(page)).scale).toBeCloseTo(2 * start.scale);
  const zoomed = await cameraOf(page);
  expect(zoomed.x).toBeLessThan(start.x);
  expect(zoomed.y).toBeGreaterThan(start.y);
  await page.getByRole("button", { name: "Fit" }).click();
  await expect.poll(() => cameraOf(page)).toEqual(start);
  expect(theatre.complaints).toEqual([]);
});

test("the view stays while a drawing is edited, and fits another one", async () => {
  const page = await rig("scene=utm");
  const start = await cameraOf(page);
  await page.getByRole("button", { name: "Edit" }).click();
  await settle(page);
  expect(await cameraOf(page)).toEqual(start);
  await page.getByRole("button", { name: "Another drawing" }).click();
  await expect.poll(async () => (await cameraOf(page)).scale).toBeLessThan(start.scale / 1000);
  expect(theatre.complaints).toEqual([]);
});

test("two fingers zoom, and what is between them stays", async () => {
  const page = await rig("scene=values", { hasTouch: true });
  const start = await cameraOf(page);
  const session = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...points: [number, number][]) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  await touch("touchStart", [350, 300]);
  await touch("touchStart", [350, 300], [450, 300]);
  for (const far of [60, 80, 100]) await touch("touchMove", [400 - far, 300], [400 + far, 300]);
  await touch("touchEnd");
  await expect.poll(async () => (await cameraOf(page)).scale / start.scale).toBeCloseTo(2, 1);
  const end = await cameraOf(page);
  expect(Math.abs(end.x - start.x) * end.scale).toBeLessThan(3);
  expect(theatre.complaints).toEqual([]);
});

test("a picture has the resolution of the screen", async () => {
  const page = await rig("scene=values", { deviceScaleFactor: 2 });
  await page.getByRole("button", { name: "Take a picture" }).click();
  await page.locator("#rig[data-picture]").waitFor();
  expect(await page.locator("#rig").getAttribute("data-picture")).toBe("1600×1200");
  const canvas = page.locator("canvas[data-renderer]");
  await expect.poll(() => canvas.evaluate((one: HTMLCanvasElement) => one.width)).toBe(1600);
  expect(theatre.complaints).toEqual([]);
});

test("moving over a hundred thousand triangles uploads nothing", async () => {
  const page = await theatre.visit();
  await page.getByRole("button", { name: "Mesh", exact: true }).click();
  await page.getByLabel("Preset").selectOption("uniform");
  const count = page.getByRole("spinbutton", { name: "Points" });
  await count.fill("50000");
  await count.press("Tab");
  await page.getByText("Points: 50,000").waitFor();
  await page.getByLabel("Delaunay triangulation").check();
  await page.getByRole("button", { name: "Mesh it" }).click();
  await page.locator(".mesh-outcome").waitFor();
  await settled(page);
  const uploads = () => page.locator("canvas[data-uploads]").getAttribute("data-uploads");
  const before = await uploads();
  await page.mouse.move(600, 400);
  await page.mouse.down();
  const times: number[] = [];
  for (let k = 0; k < 60; k++) {
    await page.mouse.move(600 + 3 * k, 400 + k);
    times.push(await frameTime(page));
  }
  await page.mouse.up();
  await settled(page);
  console.log(`median of a frame: ${times.sort((a, b) => a - b)[30].toFixed(1)} ms`);
  expect(await uploads()).toBe(before);
  expect(theatre.complaints).toEqual([]);
});

/** Milliseconds from one frame to the next. */
const frameTime = (page: Page): Promise<number> =>
  page.evaluate(
    () =>
      new Promise<number>((done) => {
        requestAnimationFrame((begin) => requestAnimationFrame((end) => done(end - begin)));
      }),
  );
