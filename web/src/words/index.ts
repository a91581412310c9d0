// What the page says, in the language of its reader. Each room has its own words; the German ones have the type of the
// English ones, so that none can be missing.

import { computed } from "@preact/signals";
import { language } from "../state/settings";
import { de } from "./de";
import { en } from "./en";

export type Words = typeof en;

/** The words of the language that is chosen. */
export const words = computed<Words>(() => (language.value === "de" ? de : en));

/** Writes a whole number with all of its digits. */
export const count = (value: number): string => value.toLocaleString(language.value);

/** Writes a number as people of the language do. */
export const number = (value: number, digits = 6): string =>
  value.toLocaleString(language.value, { maximumSignificantDigits: digits });
