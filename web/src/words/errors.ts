// Errors of the module that people meet often, in the words of the page; all others stay as the module says them.

import { count, words } from ".";

/** Says an error in the language of the page, as far as it is known. */
export function inWords(message: string): string {
  const limit = /^more than (\d+) steps\b/.exec(message);
  return limit ? words.value.play.tooLong(count(Number(limit[1]))) : message;
}
