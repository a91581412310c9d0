// The first moments: what somebody does while the page is still loading counts, not what the page begins with.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { settled, Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** Takes a preset so many milliseconds after it can be chosen. */
const choosing = (delay: number) => async (page: Page) => {
  await page.addInitScript((wait) => {
    new MutationObserver((_, observer) => {
      const option = document.querySelector<HTMLOptionElement>(".side option[value=thesis]");
      if (!option) return;
      observer.disconnect();
      setTimeout(() => {
        const select = option.closest("select")!;
        select.value = "thesis";
        select.dispatchEvent(new Event("change", { bubbles: true }));
      }, wait);
    }).observe(document, { childList: true, subtree: true });
  }, delay);
};

/** Drops a file as soon as the page listens. */
const dropping = (name: string, content: string) => async (page: Page) => {
  await page.addInitScript(
    ([of, text]) => {
      const tell = (kind: string) => {
        const data = new DataTransfer();
        data.items.add(new File([text], of));
        const event = new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true });
        document.dispatchEvent(event);
        return event.defaultPrevented;
      };
      const timer = setInterval(() => {
        if (!tell("dragover")) return;
        clearInterval(timer);
        tell("drop");
      }, 1);
    },
    [name, content],
  );
};

const counts = (page: Page, text: string) => page.getByText(`Points: ${text}`).waitFor();

test.each([
  ["", 0],
  ["", 5],
  ["", 20],
  ["", 60],
  ["#preset=uniform&n=100000", 5],
  ["#preset=uniform&n=100000&mode=mesh", 60],
])("on a page with the address '%s' a preset chosen after %i ms stays", async (address, delay) => {
  const page = await theatre.visit(address, {}, choosing(delay));
  await counts(page, "9, segments: 9, holes: 1");
  await settled(page);
  await counts(page, "9, segments: 9, holes: 1");
  await expect.poll(() => page.url()).toContain("preset=thesis");
  expect(theatre.complaints).toEqual([]);
});

/** Opens the page without its module, which comes when the function is called. */
async function unready(): Promise<{ page: Page; come: () => void }> {
  let come = () => {};
  const awaited = new Promise<void>((done) => {
    come = done;
  });
  const page = await theatre.visit("", {}, async (blank) => {
    await blank.route("**/*.wasm", async (route) => {
      await awaited;
      await route.continue();
    });
  });
  return { page, come };
}

test("whoever changes their mind before the module has come gets what they want, and a whole page", async () => {
  const { page, come } = await unready();
  const count = page.getByRole("spinbutton", { name: "Points" });
  for (const wanted of ["50", "60"]) {
    await count.fill(wanted);
    await count.press("Tab");
  }
  come();
  await counts(page, "60, segments: 0, holes: 0");
  await settled(page);
  await expect.poll(() => page.getByLabel("Preset").locator("option").count()).toBeGreaterThan(25);
  await page.getByRole("button", { name: "Play", exact: true }).last().click();
  expect(theatre.complaints).toEqual([]);
});

test("a file is opened, though what was to be drawn before is given up", async () => {
  const { page, come } = await unready();
  const count = page.getByRole("spinbutton", { name: "Points" });
  await count.fill("50");
  await count.press("Tab");
  const file = { name: "three.csv", mimeType: "text/csv", buffer: Buffer.from("0,0\n1,0\n0,1\n") };
  await page.locator("input[type=file]").setInputFiles(file);
  // It has most likely been read by then, and is being asked about; if not, nothing is tested, and nothing fails.
  await page.waitForTimeout(200);
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("Escape");
  come();
  await counts(page, "3, segments: 0, holes: 0");
  expect(theatre.complaints).toEqual([]);
});

test("a file dropped in the first moments stays; one that is broken leaves the usual drawing", async () => {
  const page = await theatre.visit("", {}, dropping("three.csv", "0,0\n1,0\n0,1\n"));
  await counts(page, "3, segments: 0, holes: 0");
  await settled(page);
  await counts(page, "3, segments: 0, holes: 0");
  const other = await theatre.visit("", {}, dropping("three.csv", "0,0\n1,oops\n"));
  await other.getByRole("alert").filter({ hasText: "three.csv:2" }).waitFor();
  await counts(other, "40, segments: 0, holes: 0");
  expect(theatre.complaints).toEqual([]);
});
