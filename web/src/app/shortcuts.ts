// Keys that work without a field of their own, except where text is written: what they do, and how the list of all of
// them, which opens with "?", calls that.

import { useEffect } from "preact/hooks";
import { type Mode, mode } from "../state/mode";
import type { Words } from "../words";

/** Where a key works: on the whole page, in one mode, or while the stage has the focus. */
export type Where = "page" | "drawing" | "stage" | Mode;

/** What a key does, as `words.help.does` calls it. */
export type Does = keyof Words["help"]["does"];

export interface Shortcut {
  where: Where;
  /** `event.key`, letters small, with `Control+` (on a Mac that is ⌘) and `Shift+` before it. */
  keys: string;
  does: Does;
  /** Missing where somebody else listens, who has a place that the key is about. */
  act?: (() => void) | undefined;
}

/** All there are, in the order of the list. */
const all: Shortcut[] = [];

/** Gives a key its meaning; one that it had before in the same place is gone. */
export function bind(where: Where, keys: string, does: Does, act?: () => void): void {
  const shortcut = { where, keys, does, act };
  const before = all.findIndex((each) => each.where === where && each.keys === keys);
  if (before < 0) all.push(shortcut);
  else all[before] = shortcut;
}

/** Lists the keys of one place: what is done, and all keys that do it. */
export function listed(where: Where): { does: Does; keys: string[] }[] {
  const found = new Map<Does, string[]>();
  for (const { does, keys } of all.filter((each) => each.where === where)) {
    found.set(does, [...(found.get(does) ?? []), keys]);
  }
  return [...found].map(([does, keys]) => ({ does, keys }));
}

/** Finds what a key does in a mode; that of the mode itself comes first. */
export function meaning(of: Mode, event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "shiftKey">) {
  const { key, ctrlKey, metaKey, shiftKey } = event;
  const letter = key.length === 1 ? key.toLowerCase() : key;
  const control = ctrlKey || metaKey ? "Control+" : "";
  // Signs such as "?" take Shift on some keyboards and not on others.
  const names = [`${control}${shiftKey ? "Shift+" : ""}${letter}`, `${control}${letter}`];
  const isSign = !/[\p{L}\p{N} ]/u.test(letter);
  const sought = shiftKey && !(isSign && key.length === 1) ? names.slice(0, 1) : names;
  for (const where of [of, "drawing", "page"] as const) {
    for (const name of sought) {
      const found = all.find((each) => each.act && each.where === where && each.keys === name);
      if (found) return found.act;
    }
  }
  return undefined;
}

export function useShortcuts(): void {
  useEffect(() => {
    document.addEventListener("keydown", press);
    return () => document.removeEventListener("keydown", press);
  }, []);
}

function press(event: KeyboardEvent): void {
  if (event.defaultPrevented || event.altKey || isSpokenFor(event)) return;
  const act = meaning(mode.peek(), event);
  if (!act) return;
  event.preventDefault();
  act();
}

/** Tells whether the key belongs to what has the focus, or to a dialog. */
function isSpokenFor({ target, key }: KeyboardEvent): boolean {
  if (document.querySelector("dialog[open]")) return true;
  if (!(target instanceof HTMLElement)) return false;
  if (target.matches("input:not([type=range], [type=checkbox]), textarea, select")) return true;
  const isPressing = key === " " || key === "Enter";
  return isPressing && target.matches("button, summary, a, input");
}
