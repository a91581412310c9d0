// What an algorithm is called and what there is to say of it, in the language of the page as far as that is known.

import type { Algorithm } from "../engine/protocol";
import { words } from "../words";

type Told = Pick<Algorithm, "title" | "idea" | "cost" | "guarantees">;

/** Says what there is to say, and in which language. */
export function described(of: Algorithm): Told & { isEnglish: boolean } {
  const own = words.value.play.algorithms[of.name];
  return { ...(own ?? of), isEnglish: own === undefined };
}

/** Names a kind of steps. */
export const sayKind = (kind: string): string => words.value.play.steps[kind] ?? kind;

/** Writes a title as the beginning of a line. */
export function titleOf(name: string, title: string): string {
  const told = words.value.play.algorithms[name]?.title ?? title;
  return told.charAt(0).toUpperCase() + told.slice(1);
}
