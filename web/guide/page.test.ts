// What becomes of a text of the guide.

import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { pageAt, pageOf } from "./page";

test("links lead to pages", () => {
  expect(pageAt("greedy-flips.md#why-it-ends")).toBe("greedy-flips.html#why-it-ends");
  expect(pageAt("../../REFERENCES.md")).toBe("references.html");
  expect(pageAt("../terrain.md")).toBeNull();
  expect(pageAt("README.md")).toBe("index.html");
  expect(pageAt("https://example.org/a.md")).toBe("https://example.org/a.md");
  expect(pageAt("pictures/sweep.png")).toBe("pictures/sweep.png");
});

test("a page has its title, its pictures and the way to the stage", () => {
  const page = pageOf("# Flips & more\n\n![Edges](pictures/a.svg)\n\n## Why it ends\n", "edge-flip");
  expect(page).toContain("<title>Flips &amp; more – Delone</title>");
  expect(page).toContain('alt="Edges"');
  expect(page).toContain('id="why-it-ends"');
  expect(page).toContain("../#algorithm=edge-flip");
});

test("every link within the guide leads somewhere", () => {
  const folder = new URL("../../docs/algorithms/", import.meta.url);
  const texts = readdirSync(folder).filter((name) => name.endsWith(".md"));
  const read = (name: string) => pageOf(readFileSync(new URL(name, folder), "utf8"), null);
  const pages = new Map(texts.map((name) => [pageAt(name), read(name)]));
  expect(pages.size).toBeGreaterThan(18);
  for (const [name, page] of pages) {
    const text = page.slice(page.indexOf("<main>"));
    for (const [, href] of text.matchAll(/href="([^"]*)"/g)) {
      if (/^[a-z]+:/.test(href) || href.startsWith("references.html")) continue;
      const [path, place] = href.split("#");
      const target = path === "" ? page : pages.get(path);
      expect(target, `${name}: ${href}`).toBeDefined();
      if (place) expect(target, `${name}: ${href}`).toContain(`id="${place}"`);
    }
  }
});
