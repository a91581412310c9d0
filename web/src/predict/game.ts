// The rules of the game: what is offered, how a guess is judged, what it is worth.

import { keyOf, type Quad } from "./edges";

/** right: this one is next. almost: it must go as well, but another is next. wrong: it may stay for now. */
export type Verdict = "right" | "almost" | "wrong";

/** Judges a guess; `illegal` are the names of the edges that are not locally Delaunay. */
export function judge(guess: Quad, answer: Quad, illegal: ReadonlySet<string>): Verdict {
  if (keyOf(guess.edge) === keyOf(answer.edge)) return "right";
  return illegal.has(keyOf(guess.edge)) ? "almost" : "wrong";
}

export interface Score {
  asked: number;
  right: number;
  /** Right ones in a row, without a hint. */
  streak: number;
  best: number;
}

export const noScore: Score = { asked: 0, right: 0, streak: 0, best: 0 };

/** Counts a guess. A hint is no help to the streak, and an edge that must go as well does not end it. */
export function scored({ asked, right, streak, best }: Score, verdict: Verdict, isHinted: boolean): Score {
  const row = verdict === "wrong" ? 0 : streak + (verdict === "right" && !isHinted ? 1 : 0);
  return {
    asked: asked + 1,
    right: right + (verdict === "right" ? 1 : 0),
    streak: row,
    best: Math.max(best, row),
  };
}

/** How many edges are offered in the easy game. */
export const OFFERED = 3;

/**
 * Chooses edges to be offered beside the right one: if possible one that must go too, and one that touches it.
 *
 * The same for the same puzzle; sorted, so that the place in the list tells nothing.
 */
export function offer(all: Quad[], answer: Quad, illegal: ReadonlySet<string>, seed: number): Quad[] {
  const isAnswer = (quad: Quad) => keyOf(quad.edge) === keyOf(answer.edge);
  const others = all.filter((quad) => !isAnswer(quad));
  others.sort((a, b) => mix(seed, a) - mix(seed, b));
  const touches = ({ edge }: Quad) => edge.some((v) => answer.edge.includes(v));
  const preferred = [
    others.find(({ edge }) => illegal.has(keyOf(edge))),
    others.find((quad) => touches(quad) && !illegal.has(keyOf(quad.edge))),
    ...others,
  ];
  const chosen = new Set<Quad>();
  for (const quad of preferred) if (quad && chosen.size < OFFERED - 1) chosen.add(quad);
  return all.filter((quad) => isAnswer(quad) || chosen.has(quad));
}

// Stirs numbers as hash functions do.
function mix(seed: number, { edge: [a, b] }: Quad): number {
  let h = seed ^ Math.imul(a + 1, 0x9e3779b1) ^ Math.imul(b + 1, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  return (h ^ (h >>> 13)) >>> 0;
}
