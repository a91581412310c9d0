// Somebody who presses whatever there is, faster than the page can follow, and drops files in between.

import { afterAll, beforeAll, expect, test } from "vitest";
import { Theatre } from "./page";

let theatre: Theatre;
beforeAll(async () => {
  theatre = await Theatre.open();
});
afterAll(() => theatre.close());

/** How long one of them goes on, in milliseconds. */
const TIME = 5000;

/** What is complained about, but for what browsers let nobody do without a hand. */
const complaints = () => theatre.complaints.filter((text) => !text.includes("user activation"));

/** Presses this and that, in the page; returns what came last, to be told if it was too much, and what the page said. */
// biome-ignore lint/complexity/noExcessiveLinesPerFunction: it runs in the page, where it must be whole
async function press({
  seed,
  time,
}: {
  seed: number;
  time: number;
}): Promise<{ log: string[]; said: string[] }> {
  let state = seed;
  const random = (below: number) => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
  const fire = (element: Element, name: string) => element.dispatchEvent(new Event(name, { bubbles: true }));
  const set = (field: HTMLInputElement | HTMLSelectElement, value: string) => {
    field.value = value;
    fire(field, "input");
    fire(field, "change");
  };
  const drop = (name: string, content: string) => {
    const data = new DataTransfer();
    data.items.add(new File([content], name));
    for (const kind of ["dragover", "drop"])
      document.body.dispatchEvent(
        new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }),
      );
  };
  const many = Array.from({ length: 3000 }, (_, i) => `${Math.sin(i)} ${Math.cos(3 * i)}`).join("\n");
  const files: [string, string][] = [
    ["square.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1))"],
    ["many.csv", many],
    ["crossing.poly", "4 2 0 0\n1 0 0\n2 1 1\n3 0 1\n4 1 0\n2 0\n1 1 2\n2 3 4\n0\n"],
    ["line.csv", "0 0\n1 1\n2 2\n"],
    ["broken.csv", "0 0\n1 zero\n"],
    ["empty.csv", ""],
  ];
  const keys = [
    "Escape",
    "Enter",
    " ",
    "ArrowRight",
    "ArrowLeft",
    "Home",
    "End",
    "f",
    "i",
    "p",
    "s",
    "v",
    "Delete",
  ];
  const links = [
    "#preset=thesis&mode=mesh",
    "#preset=uniform&n=30&algorithm=flip-list&at=5",
    "#drawing=AAAA",
    "#x",
  ];
  const log: string[] = [];
  const said = new Set<string>();
  const end = performance.now() + time;
  while (performance.now() < end) {
    for (const { textContent } of document.querySelectorAll(".notice.error span")) said.add(textContent);
    const dialog = document.querySelector("dialog[open]");
    const all = [
      ...(dialog ?? document).querySelectorAll<HTMLElement>("button, select, input, summary, .stage-view"),
    ].filter(
      (element) =>
        element.checkVisibility() &&
        !element.nextElementSibling?.matches("[type=file]") &&
        !(element as HTMLButtonElement).disabled,
    );
    if (all.length === 0) {
      await new Promise(requestAnimationFrame);
      continue;
    }
    const one = all[random(all.length)];
    const name = `${one.tagName} ${one.getAttribute("aria-label") ?? one.textContent?.slice(0, 30)}`;
    const choice = random(40);
    if (choice === 0 && !dialog) drop(...files[random(files.length)]);
    else if (choice < 4) {
      const key = keys[random(keys.length)];
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    } else if (choice === 4) location.hash = links[random(links.length)];
    else if (one instanceof HTMLSelectElement) {
      const options = [...one.options].filter((option) => option.value !== "" && !option.disabled);
      if (options.length > 0) set(one, options[random(options.length)].value);
    } else if (one instanceof HTMLInputElement && one.type === "range")
      set(one, String(Number(one.min) + (random(101) / 100) * (Number(one.max) - Number(one.min))));
    else if (one instanceof HTMLInputElement && ["number", "text"].includes(one.type))
      set(one, ["", "0", "3", "25", "-1", "0.3", "200", one.type === "text" ? "x" : "7"][random(8)]);
    else if (one.matches(".stage-view")) {
      const box = one.getBoundingClientRect();
      const at = { clientX: box.x + random(box.width), clientY: box.y + random(box.height) };
      const canvas = one.querySelector("canvas:last-of-type") ?? one;
      for (const kind of ["pointermove", "pointerdown", "pointerup"])
        canvas.dispatchEvent(
          new PointerEvent(kind, { ...at, pointerId: 1, isPrimary: true, bubbles: true, cancelable: true }),
        );
    } else one.click();
    log.push(name);
    if (random(3) > 0) await new Promise((next) => setTimeout(next, random(60)));
  }
  return { log: log.slice(-12), said: [...said] };
}

test.each([1, 2, 3, 4, 5, 6])("monkey %i leaves a living page", async (seed) => {
  const page = await theatre.visit();
  await page.getByText("Points: 40").waitFor();
  const { log, said } = await page.evaluate(press, { seed, time: TIME });
  expect(complaints(), log.join(" | ")).toEqual([]);

  // What goes wrong is said in words for people.
  expect(
    said.filter((text) =>
      /\bbug\b|undefined|unreachable|pointer|recursive|destructure|not a function|cannot show/i.test(text),
    ),
  ).toEqual([]);
  // Whatever is under way or open now, and in whichever language: a drawing is opened, and meshed.
  for (let k = 0; k < 3; k++) await page.keyboard.press("Escape");
  await page.evaluate(() => {
    const pressed = ".notice button:last-child, .head > [aria-expanded=false]";
    for (const button of document.querySelectorAll<HTMLElement>(pressed)) button.click();
  });
  await page.evaluate(() => {
    const select = document.querySelector<HTMLSelectElement>("select:has([value=de])")!;
    select.value = "en";
    select.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await page.locator("nav").getByRole("button", { name: "Mesh", exact: true }).click();
  await page.getByLabel("Preset").selectOption("thesis");
  await page.getByText("Points: 9, segments: 9, holes: 1").waitFor();
  await page.getByRole("tab", { name: "Options" }).click();
  await page.getByRole("radio", { name: /^With segments/ }).check();
  await page.getByRole("button", { name: "Mesh it" }).click();
  await page
    .locator(".mesh-outcome")
    .getByText(/triangle/)
    .waitFor();
  await page.locator("nav").getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => page.getByRole("slider", { name: "Position" }).getAttribute("max")).not.toBe("0");
  expect(complaints(), log.join(" | ")).toEqual([]);
});
