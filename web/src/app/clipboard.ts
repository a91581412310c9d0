// Texts for the clipboard.

import { tell } from "../state/notices";

/** Copies a text, and returns whether the browser let it; otherwise somebody is told why not. */
export async function copy(text: string, otherwise: (error: unknown) => void = tell): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch (error) {
    otherwise(error);
    return false;
  }
}
