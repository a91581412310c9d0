// What a reader of the page has chosen, kept from visit to visit.

import { effect, type Signal, signal } from "@preact/signals";
import type { Language } from "../engine/protocol";

export type Theme = "auto" | "light" | "dark";

/** The language of the page and of the narration. */
export const language: Signal<Language> = kept("language", browserLanguage(), ["en", "de"]);

/** Light, dark, or as the system has it. */
export const theme: Signal<Theme> = kept<Theme>("theme", "auto", ["auto", "light", "dark"]);

/** Whether the system asks for less motion. */
export const wantsLessMotion = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

function browserLanguage(): Language {
  return navigator.language.startsWith("de") ? "de" : "en";
}

/** Makes a signal whose value outlives the page; anything but `allowed` is forgotten. */
export function kept<T extends string>(name: string, usual: NoInfer<T>, allowed: T[]): Signal<T> {
  const key = `delone.${name}`;
  const stored = read(key) as T | null;
  const value = signal(stored !== null && allowed.includes(stored) ? stored : usual);
  effect(() => write(key, value.value));
  return value;
}

/** Reads what was kept. Storage may be forbidden; then nothing is. */
export function read(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Keeps something until the next visit. */
export function write(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // Kept until the page is left.
  }
}
