// The corpus in the page: whatever lies in the shared folder of data beside the checkout is opened, one file after the
// other, in one page that never hangs or complains; and what it makes of some of them is what the program makes of them.

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { basename, dirname } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { Drawing, formats, initSync } from "../../src/wasm/delone.js";
import { Theatre } from "./page";

const corpus = fileURLToPath(new URL("../../../../shared/data", import.meta.url));
const program = fileURLToPath(new URL("../../../target/release/delone", import.meta.url));

/** What other programs made of inputs, and lists that are no drawings: hundreds of the same kind, or none of ours. */
const left = ["cdt/expected", "predicates", "README.md", "FUNCTIONS.md"];

/** How many are compared with what the program makes of them. */
const SAMPLE = 16;

/** Folders of many files of a kind: of these one in five. */
const alike = ["airfoil/", "earcut/"];

/** Milliseconds for all of them. They take half a minute alone, on a machine with much else to do many: a hang ends it. */
const LONG = 1_200_000;

/** Drawings with more points are shown without a run. */
const FEW = 500;

/** A file with those beside it that belong to it. */
interface Input {
  path: string;
  name: string;
  files: { name: string; mimeType: string; buffer: Buffer }[];
}

let theatre: Theatre;
beforeAll(async () => {
  initSync({ module: readFileSync(new URL("../../src/wasm/delone_bg.wasm", import.meta.url)) });
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

const stem = (path: string) => path.replace(/\.[^./]*$/, "");

/** Lists what there is to open. */
function inputs(): Input[] {
  const known: { reads: boolean; extensions: string[] }[] = JSON.parse(formats());
  const extensions = new Set(known.filter(({ reads }) => reads).flatMap((format) => format.extensions));
  const all = readdirSync(corpus, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => `${parentPath}/${name}`)
    .filter((path) => !left.some((part) => path.startsWith(`${corpus}/${part}`) || path.endsWith(`/${part}`)))
    .filter((path) => extensions.has(path.replace(/^.*\./, "").toLowerCase()))
    .sort();
  // Of the files of a mesh each brings the others along: they are opened once.
  const isFirst = (path: string, i: number) => i === 0 || stem(all[i - 1]) !== stem(path);
  const first = all
    .filter(isFirst)
    .filter((path, i) => i % 5 === 0 || !alike.some((part) => path.includes(part)));
  return first.map((path) => {
    const family = /\.(ele|node|poly)$/.test(path)
      ? all.filter((each) => stem(each) === stem(path) && dirname(each) === dirname(path))
      : [path];
    const files = family.map((each) => ({
      name: basename(each),
      mimeType: "application/octet-stream",
      buffer: readFileSync(each),
    }));
    return { path, name: path.slice(corpus.length + 1), files };
  });
}

/** What the module itself makes of an input: what the page is to say of it. */
function expected({ files }: Input): { says: string; points: number } | { fails: string } {
  const order = ["ele", "poly", "node"];
  const rank = (name: string) => (order.indexOf(name.replace(/^.*\./, "")) + 4) % 4;
  const sorted = files.toSorted((a, b) => rank(a.name) - rank(b.name));
  try {
    const drawing = Drawing.fromFiles(
      sorted.map(({ name }) => name),
      sorted.map(({ buffer }) => new Uint8Array(buffer)),
    );
    const { points, segments, holes } = JSON.parse(drawing.about());
    drawing.free();
    const written = (count: number) => count.toLocaleString("en");
    return {
      says: `Points: ${written(points)}, segments: ${written(segments)}, holes: ${written(holes)}`,
      points,
    };
  } catch (error) {
    return { fails: (error as Error).message };
  }
}

const field = (page: Page) => page.locator("input[type=file]");
const about = (page: Page) => page.locator("p.about").last();
const inMode = (page: Page, name: string) =>
  page.locator("nav").getByRole("button", { name, exact: true }).click();

/** Begins with nothing, so that whatever comes is news. */
async function clear(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Start empty" }).click();
  await page.getByText("Points: 0, segments: 0, holes: 0").waitFor();
  await page.evaluate(() => {
    for (const button of document.querySelectorAll<HTMLElement>(".notice [aria-label=Dismiss]"))
      button.click();
  });
}

test.skipIf(!existsSync(corpus))(
  "every file of the corpus is shown, or an error says what is wrong",
  async () => {
    const page = await theatre.visit();
    await about(page).waitFor();
    const all = inputs();
    expect(all.length).toBeGreaterThan(140);
    const silent: string[] = [];
    const since = performance.now();
    for (const input of all) {
      const wanted = expected(input);
      await clear(page);
      await inMode(page, "points" in wanted && wanted.points > FEW ? "Mesh" : "Play");
      await field(page).setInputFiles(input.files);
      const sign =
        "says" in wanted
          ? page.getByText(wanted.says)
          : page.getByRole("alert").filter({ hasText: wanted.fails.slice(0, 200) });
      await sign
        .waitFor()
        .catch(async () =>
          silent.push(
            `${input.name}: ${JSON.stringify(wanted)} ${await about(page).textContent()} ${await page.locator(".notice").allTextContents()}`,
          ),
        );
    }
    console.log(`${all.length} files of the corpus: ${((performance.now() - since) / 1000).toFixed(1)} s`);
    expect(silent).toEqual([]);
    expect(theatre.complaints).toEqual([]);
  },
  LONG,
);

/** Some inputs that can be drawn, from the smallest to the largest. */
function sample(): (Input & { points: number })[] {
  const drawn = inputs().flatMap((input) => {
    const wanted = expected(input);
    return "points" in wanted && wanted.points > 2 ? [{ ...input, points: wanted.points }] : [];
  });
  drawn.sort((a, b) => a.points - b.points);
  return drawn.filter((_, i) => i % Math.ceil(drawn.length / SAMPLE) === 0);
}

/** What the program makes of a file: the hash, or why there is none. */
function byProgram(path: string): { hash: string } | { fails: true } {
  try {
    const told = execFileSync(program, ["triangulate", path, "--json", "-q"], {
      stdio: ["ignore", "pipe", "pipe"],
    });
    return { hash: JSON.parse(told.toString()).hash };
  } catch {
    return { fails: true };
  }
}

test.skipIf(!existsSync(corpus) || !existsSync(program))(
  "page and program make the same of files",
  async () => {
    const page = await theatre.visit("#mode=mesh&kind=constrain");
    await page.getByText("Points: 40").waitFor();
    for (const { name, path, files, points } of sample()) {
      await clear(page);
      await field(page).setInputFiles(files);
      await page.getByText(`Points: ${points.toLocaleString("en")},`).waitFor();
      // With the files of a mesh the page opens its segments, too; the program has to be told to.
      const poly = files.find((file) => file.name.endsWith(".poly"))?.name ?? basename(path);
      const wanted = byProgram(`${dirname(path)}/${poly}`);
      await page.getByRole("tab", { name: "Export" }).click();
      await page.getByRole("button", { name: "Mesh it" }).click();
      if ("fails" in wanted) {
        await page.getByRole("alert").waitFor();
        continue;
      }
      const hash = page
        .locator(".mesh-copy code")
        .first()
        .filter({ hasText: /^[0-9a-f]{32}$/ });
      expect(await hash.textContent(), name).toBe(wanted.hash);
    }
    expect(theatre.complaints).toEqual([]);
  },
  LONG,
);
