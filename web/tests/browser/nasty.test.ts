// What nobody should open, and somebody will: it is shown, or said to be wrong, and the page goes on. And whatever takes
// long is cancelled at any moment.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const file = (name: string, content: string | Buffer) => ({
  name,
  mimeType: "application/octet-stream",
  buffer: Buffer.from(content as string),
});
const field = (page: Page) => page.locator("input[type=file]");
const notice = (page: Page, text: string) => page.locator(".notice").filter({ hasText: text });
const points = (page: Page, count: string) => page.getByText(`Points: ${count},`).waitFor();
const inMode = (page: Page, name: string) =>
  page.locator("nav").getByRole("button", { name, exact: true }).click();
const outcome = (page: Page) => page.locator(".mesh-outcome");

/** Drops text as a file. */
const drop = (page: Page, name: string, content: string) =>
  page.evaluate(
    ([of, text]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], of));
      const event = new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true });
      document.body.dispatchEvent(event);
    },
    [name, content],
  );

const junk = Buffer.from(Array.from({ length: 5000 }, (_, i) => (i * 7919) % 251));

/** What is refused, and what is said about it. */
const refused: [name: string, content: string | Buffer, says: string][] = [
  ["inf.csv", "0,0\n1,inf\n", "inf.csv:2"],
  ["junk.bin", junk, "junk.bin: of no kind"],
  ["junk.csv", junk, "junk.csv at byte 0"],
  ["lonely.poly", "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n", "lonely.poly needs lonely.node"],
  ["zip.poly", Buffer.from("504b0304140000000800", "hex"), "zip.poly:1"],
  ["<b>bold<img src=x>.csv", "0 0\n1 zero\n", "<b>bold<img src=x>.csv:2"],
  ["blank.csv", "\n\n\n", "the file is empty"],
  ["long.csv", "1 ".repeat(4_000_000), "4000000 columns"],
];

test("what cannot be opened is said to be wrong, and the drawing stays", async () => {
  const page = await theatre.visit("#preset=thesis");
  await points(page, "9");
  for (const [name, content, says] of refused) {
    await field(page).setInputFiles([file(name, content)]);
    await notice(page, says).waitFor();
    await points(page, "9");
  }
  expect(theatre.complaints).toEqual([]);
});

/** What is opened: how many points there are, and what a mesh of it says. */
const opened: [name: string, content: string, count: string, says: string][] = [
  ["one.csv", "1,2\n", "1", "no triangles"],
  ["two.csv", "1,2\n1,2\n", "2", "no triangles"],
  ["line.csv", "0,0\n1,1\n2,2\n3,3\n", "4", "no triangles"],
  ["huge.csv", "0,0\n1e308,0\n0,1e308\n-1e308,-1e308\n", "4", "3 triangles"],
  ["tiny.csv", "0,0\n1e-320,0\n0,1e-320\n", "3", "1 triangle,"],
  ["mixed.csv", "0,0\n1e-320,0\n0,1e308\n1,1\n", "4", "2 triangles"],
  ["utm.csv", "500000.001,5400000.002\n500000.003,5400000.002\n500000.001,5400000.005\n", "3", "1 triangle,"],
  [`quo"te's ü 😀.csv`, "0 0\n1 0\n0 1\n1 1", "4", "2 triangles"],
  ["noextension", "0 0\n1 0\n0 1\n", "3", "1 triangle,"],
  ["header.csv", "x,y\n", "0", "no triangles"],
];

test("what is strange but sound is shown and worked with in every mode", async () => {
  const page = await theatre.visit("#mode=mesh&kind=constrain");
  await points(page, "40");
  for (const [name, content, count, says] of opened) {
    await inMode(page, "Mesh");
    await field(page).setInputFiles([file(name, content)]);
    await points(page, count);
    await page.getByRole("button", { name: "Mesh it" }).click();
    await outcome(page).filter({ hasText: says }).waitFor();
    // What is meshed is what is asked for.
    expect(await page.getByText("Other options are chosen by now.").count()).toBe(0);
    for (const mode of ["Play", "Predict", "Race"]) await inMode(page, mode);
  }
  await notice(page, "there are no points in it").waitFor();
  // The same file again, and a folder, which no browser reads.
  await field(page).setInputFiles([file("noextension", "0 0\n1 0\n0 1\n")]);
  await points(page, "3");
  await field(page).setInputFiles([file("noextension", "0 0\n1 0\n0 1\n1 1\n")]);
  await points(page, "4");
  expect(theatre.complaints).toEqual([]);
});

test("large files are opened, meshed and given up at any moment", async () => {
  const page = await theatre.visit("#mode=mesh&kind=triangulate");
  await points(page, "40");
  const million = Array.from({ length: 1_000_000 }, (_, i) => `${Math.sin(i)},${Math.cos(3.1 * i)}`).join(
    "\n",
  );
  // Another one while it is opened: that one is shown, and stays.
  await drop(page, "million.csv", million);
  await drop(page, "three.csv", "0 0\n1 0\n0 1\n");
  await points(page, "3");
  await settled(page);
  await points(page, "3");
  await drop(page, "million.csv", million);
  await points(page, "1,000,000");
  // Given up while it is meshed, then something else is dropped in the middle of another mesh.
  const build = page.getByRole("button", { name: "Mesh it" });
  await build.click();
  await page.waitForTimeout(400);
  await page.keyboard.press("Escape");
  // Fast machines may have been done by then.
  await page.getByText("There is no mesh yet.").or(outcome(page)).first().waitFor();
  await build.click();
  await page.waitForTimeout(400);
  await drop(page, "three.csv", "0 0\n1 0\n0 1\n");
  await points(page, "3");
  await build.click();
  await outcome(page).filter({ hasText: "1 triangle," }).waitFor();
  expect(theatre.complaints).toEqual([]);
});
