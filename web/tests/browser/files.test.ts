// Files: what is saved is opened again, and what cannot be opened is said to be.

import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const counts = (page: Page, points: number, segments: number, holes: number) =>
  page.getByText(`Points: ${points}, segments: ${segments}, holes: ${holes}`).waitFor();

interface Saved {
  name: string;
  buffer: Buffer;
}

/** Saves something in a format; returns the file that the browser gets. */
async function save(page: Page, what: string, extension: string, more = async () => {}): Promise<Saved> {
  await page.getByRole("button", { name: "Save …" }).click();
  await page.getByRole("radio", { name: what, exact: true }).check();
  await page.getByLabel("Format").selectOption(extension);
  await more();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("dialog").getByRole("button", { name: "Save" }).click(),
  ]);
  return { name: download.suggestedFilename(), buffer: readFileSync(await download.path()) };
}

const open = (page: Page, ...files: Saved[]) =>
  page
    .locator("input[type=file]")
    .setInputFiles(files.map((file) => ({ ...file, mimeType: "application/octet-stream" })));

const text = (name: string, content: string): Saved => ({ name, buffer: Buffer.from(content) });

test("drawings are saved and opened again, in every format that can hold them", async () => {
  const page = await theatre.visit("#preset=thesis");
  await counts(page, 9, 9, 1);
  const poly = await save(page, "Drawing", "poly");
  expect(poly.name).toBe("thesis.poly");
  await page.getByLabel("Preset").selectOption("collinear");
  await counts(page, 24, 0, 0);
  for (const extension of ["csv", "node", "npy", "vtu", "geojson"]) {
    const saved = await save(page, "Drawing", extension);
    await page.getByLabel("Preset").selectOption("thesis");
    await counts(page, 9, 9, 1);
    await open(page, saved);
    await counts(page, 24, 0, 0);
  }
  await open(page, poly);
  await counts(page, 9, 9, 1);
  await page.getByLabel("Preset").selectOption("coast");
  await counts(page, 120, 120, 0);
  const geojson = await save(page, "Drawing", "geojson");
  await page.getByRole("button", { name: "Start empty" }).click();
  await counts(page, 0, 0, 0);
  await open(page, geojson);
  await counts(page, 120, 120, 0);
  expect(theatre.complaints).toEqual([]);
});

test("a mesh is saved as one .zip, and its files open together", async () => {
  const page = await theatre.visit("#mode=mesh&preset=thesis");
  await counts(page, 9, 9, 1);
  await page.getByRole("button", { name: "Mesh it" }).click();
  await page.locator(".mesh-outcome").waitFor();
  const zip = await save(page, "Mesh", "ele");
  expect(zip.name).toBe("thesis.zip");
  const { unzipSync } = await import("fflate");
  const files = Object.entries(unzipSync(zip.buffer)).map(([name, bytes]) => ({
    name,
    buffer: Buffer.from(bytes),
  }));
  expect(files.map(({ name }) => name).sort()).toEqual(expect.arrayContaining(["thesis.ele", "thesis.node"]));
  await open(page, ...files);
  await page.getByRole("option", { name: "Own drawing" }).waitFor({ state: "attached" });
  const svg = await save(page, "Picture of the stage", "png");
  expect(svg.buffer.subarray(1, 4).toString()).toBe("PNG");
  // Half of a mesh is none.
  await open(page, files.find(({ name }) => name.endsWith(".ele"))!);
  await page.getByRole("alert").filter({ hasText: "thesis.node" }).waitFor();
  expect(theatre.complaints).toEqual([]);
});

test("a run is saved as a log, which is played again, as an animation and as a video", async () => {
  const page = await theatre.visit("#preset=uniform&n=9&seed=4&algorithm=incremental");
  await counts(page, 9, 0, 0);
  const length = page.getByRole("slider", { name: "Position" });
  await expect.poll(() => length.getAttribute("max")).not.toBe("0");
  const steps = await length.getAttribute("max");
  const log = await save(page, "Run", "dlog");
  const gif = await save(page, "Run", "gif", async () => {
    await page.getByLabel("Width in pixels").fill("200");
    await page.getByLabel("Seconds").fill("1");
  });
  expect(gif.buffer.subarray(0, 3).toString()).toBe("GIF");
  const video = await save(page, "Run", "webm", async () => {
    await page.getByLabel("Width in pixels").fill("320");
    await page.getByLabel("Seconds").fill("2");
  });
  // The mark of EBML.
  expect(video.buffer.readUInt32BE(0)).toBe(0x1a45dfa3);
  expect(video.buffer.length).toBeGreaterThan(2000);
  await page.getByLabel("Preset").selectOption("thesis");
  await counts(page, 9, 9, 1);
  await open(page, log);
  await counts(page, 9, 0, 0);
  await expect.poll(() => length.getAttribute("max")).toBe(steps);
  await page.getByRole("button", { name: "Mesh", exact: true }).click();
  await page.getByLabel("Preset").selectOption("thesis");
  await counts(page, 9, 9, 1);
  await open(page, log);
  await counts(page, 9, 0, 0);
  await expect.poll(() => length.getAttribute("max")).toBe(steps);
  expect(theatre.complaints).toEqual([]);
});

test("what is wrong with a file is said, with its line, and nothing changes", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  const cases: [Saved, string][] = [
    [text("bad.csv", "0,0\n1,1\n2,oops\n"), "bad.csv:3"],
    [text("empty.csv", ""), "empty.csv: the file is empty"],
    [text("photo.jpg", "\u0000\u0001\u0002"), ".geojson"],
    [text("bad.dlog", "no log"), "bad.dlog"],
    [text("bad.geojson", '{"type": "Point", "coordinates": [1'), "bad.geojson"],
  ];
  for (const [file, message] of cases) {
    await open(page, file);
    await page.getByRole("alert").filter({ hasText: message }).waitFor();
  }
  await counts(page, 40, 0, 0);
  await open(page, text("a.csv", "0,0\n1,1\n0,1\n"), text("b.csv", "1,1\n"));
  await page.getByText("left aside: b.csv").waitFor();
  await counts(page, 3, 0, 0);
  expect(theatre.complaints).toEqual([]);
});

test("files are dropped, and text is pasted", async () => {
  const page = await theatre.visit();
  await counts(page, 40, 0, 0);
  const drop = (name: string) =>
    page.evaluate((kind) => {
      const data = new DataTransfer();
      data.items.add(new File(["POLYGON ((0 0, 4 0, 0 4, 0 0))"], "a.wkt"));
      document.body.dispatchEvent(
        new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }),
      );
    }, name);
  await drop("dragover");
  await page.getByText("Drop files here").waitFor();
  await page.screenshot({ path: "test-results/drop.png" });
  await drop("drop");
  await counts(page, 3, 3, 0);
  const paste = (content: string) =>
    page.evaluate((pasted) => {
      const data = new DataTransfer();
      data.setData("text/plain", pasted);
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
    }, content);
  await paste("1 2\n3 4\n5 5\n6 1");
  await counts(page, 4, 0, 0);
  await paste("no coordinates");
  await page.getByText("no numbers in it").waitFor();
  await page.getByRole("button", { name: "Paste …" }).click();
  await page.getByLabel("Lines of x and y").fill('{"type": "MultiPoint", "coordinates": [[0, 0], [1, 1]]}');
  await page.getByRole("dialog").getByRole("button", { name: "Open" }).click();
  await counts(page, 2, 0, 0);
  expect(theatre.complaints).toEqual([]);
});

test("the address names files beside the page", async () => {
  const page = await theatre.visit("#open=open/a%20b.node,open/a%20b.poly", {}, async (fresh) => {
    await fresh.route("**/open/a%20b.node", (route) =>
      route.fulfill({ body: "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n" }),
    );
    await fresh.route("**/open/a%20b.poly", (route) =>
      route.fulfill({ body: "0 2 0 0\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n1\n0 1 1\n" }),
    );
  });
  await counts(page, 4, 4, 1);
  await expect.poll(() => page.url()).toContain("open=open/a%20b.node,open/a%20b.poly");
  expect(theatre.complaints).toEqual([]);
});
