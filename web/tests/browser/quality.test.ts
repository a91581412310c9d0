// That nobody is shut out: axe in every mode, theme and size, and with everything open; nothing sticks out at the
// side; the page holds for twice the size of letters, the colours of the system, and less motion.

import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { violations } from "./axe";
import { settled, Theatre } from "./page";

const modes = ["Play", "Predict", "Race", "Mesh"];
const sizes = {
  wide: { width: 1280, height: 720 },
  tall: { width: 800, height: 1100 },
  phone: { width: 390, height: 844 },
};

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** Opens the page, waits until it can be used, and comes into the mode. */
async function visit(options: Parameters<Theatre["visit"]>[1]): Promise<Page> {
  const page = await theatre.visit("", { reducedMotion: "reduce", ...options });
  await page.getByRole("button", { name: "Play", exact: true }).first().waitFor();
  await settled(page);
  return page;
}

/** Goes to a mode, and waits until everything is there. */
async function go(page: Page, mode: string): Promise<void> {
  await page.getByRole("navigation", { name: "What to do" }).getByRole("button", { name: mode }).click();
  await settled(page);
}

/** Tells how far the page may be scrolled to the side. */
const overhang = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

describe.each(["light", "dark"] as const)("%s", (colorScheme) => {
  test.each(Object.entries(sizes))("axe finds nothing: %s", async (_, viewport) => {
    const page = await visit({ colorScheme, viewport });
    for (const mode of modes) {
      await go(page, mode);
      if (mode === "Race") await page.locator(".lane").first().waitFor();
      expect(await violations(page), mode).toEqual([]);
      expect(await overhang(page), mode).toBe(0);
    }
    await page.context().close();
    expect(theatre.complaints).toEqual([]);
  });

  test("axe finds nothing in an open menu, nor in the help", async () => {
    const page = await visit({ colorScheme, viewport: sizes.phone });
    await page.getByRole("button", { name: "Menu", exact: true }).click();
    await settled(page);
    expect(await violations(page)).toEqual([]);
    await page.getByRole("button", { name: "Help", exact: true }).click();
    await page.getByRole("dialog", { name: "Help" }).waitFor();
    await settled(page);
    expect(await violations(page)).toEqual([]);
    await page.context().close();
  });

  test("axe finds nothing in what is opened and saved, nor in a mesh", async () => {
    const page = await visit({ colorScheme, viewport: sizes.wide });
    for (const name of ["Paste …", "Save …"]) {
      await page.getByRole("button", { name, exact: true }).first().click();
      await page.getByRole("dialog").waitFor();
      await settled(page);
      expect(await violations(page), name).toEqual([]);
      await page.keyboard.press("Escape");
      await page.getByRole("dialog").waitFor({ state: "hidden" });
    }
    await go(page, "Mesh");
    await page.getByLabel("Preset").selectOption("lake");
    await page.getByRole("button", { name: "Mesh it", exact: true }).click();
    await page.locator(".mesh-outcome").getByText("triangles").waitFor();
    for (const tab of ["Options", "Quality", "Triangle", "Export"]) {
      await page.getByRole("tab", { name: tab }).click();
      await settled(page);
      expect(await violations(page), tab).toEqual([]);
    }
    await page.context().close();
    expect(theatre.complaints).toEqual([]);
  });
});

test("each panel of a phone is there, one at a time", async () => {
  const page = await visit({ viewport: sizes.phone });
  const tabs = page.getByRole("navigation", { name: "Panels" }).getByRole("button");
  for (const tab of await tabs.all()) {
    if ((await tab.getAttribute("aria-expanded")) === "false") await tab.click();
    const panels = page.locator(".panel").filter({ visible: true });
    await expect.poll(() => panels.count()).toBe(1);
    await settled(page);
    expect(await violations(page)).toEqual([]);
  }
  await tabs.last().click();
  await expect.poll(() => page.locator(".panel").filter({ visible: true }).count()).toBe(0);
  await page.context().close();
});

test.each([
  { name: "360 pixels wide", viewport: { width: 360, height: 640 } },
  { name: "twice the size of letters", viewport: { width: 640, height: 360 } },
  { name: "four times the size of letters", viewport: { width: 320, height: 256 } },
  { name: "a phone on its side", viewport: { width: 844, height: 390 } },
  { name: "German, which is longer", viewport: { width: 360, height: 780 }, locale: "de" },
])("nothing sticks out: $name", async ({ viewport, locale = "en" }) => {
  const page = await theatre.visit("", { viewport, locale, reducedMotion: "reduce" });
  await settled(page);
  for (const tab of await page.locator(".modes button").all()) {
    await tab.click();
    await settled(page);
    expect(await overhang(page)).toBe(0);
    // Buttons of which a part is cut off could not be read.
    const cut = await page
      .locator(".modes button")
      .evaluateAll((all) =>
        all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.textContent),
      );
    expect(cut).toEqual([]);
  }
  await page.context().close();
});

test("fingers find what is to be pressed", async () => {
  const page = await visit({ viewport: sizes.phone, hasTouch: true, isMobile: true });
  for (const mode of modes) {
    await go(page, mode);
    const small = await page
      .locator("button:visible, select:visible")
      .evaluateAll((all) =>
        all
          .map((one) => ({ box: one.getBoundingClientRect(), html: one.outerHTML.slice(0, 120) }))
          .filter(({ box }) => box.right > 0 && (box.width < 24 || box.height < 24)),
      );
    expect(small, mode).toEqual([]);
  }
  await page.context().close();
});

test("what is read out does not chatter while a run plays", async () => {
  const page = await visit({ viewport: sizes.wide });
  await page
    .getByRole("region", { name: "Playing" })
    .getByRole("button", { name: "Play", exact: true })
    .click();
  const heard = await page.evaluate(async () => {
    let changes = 0;
    const live = "[aria-live=polite], [aria-live=assertive], [role=status], [role=alert]";
    const ears = new MutationObserver((all) => {
      for (const { target } of all) {
        const element = target instanceof Element ? target : target.parentElement;
        if (element?.closest(live)) changes += 1;
      }
    });
    ears.observe(document.body, { subtree: true, childList: true, characterData: true });
    // So many steps, however long they take.
    const slider = document.querySelector<HTMLInputElement>(".timeline input")!;
    const begin = slider.valueAsNumber;
    while (slider.valueAsNumber < begin + 12) await new Promise(requestAnimationFrame);
    return changes;
  });
  expect(heard).toBe(0);
  await page.context().close();
});

test("the colours of the system and less motion are kept to", async () => {
  const page = await visit({ forcedColors: "active", viewport: sizes.wide });
  expect(await violations(page)).toEqual([]);
  const chosen = page.getByRole("button", { name: "Play", exact: true }).first();
  const outline = () => chosen.evaluate((button) => getComputedStyle(button).outlineStyle);
  await expect.poll(outline).not.toBe("none");
  await expect.poll(() => page.evaluate(() => document.getAnimations().length)).toBe(0);
  await page.context().close();
  expect(theatre.complaints).toEqual([]);
});
