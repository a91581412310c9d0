// Conditions of breakpoints, as they are made of what a form says.

import type { Condition } from "../engine/protocol";

/** What the form offers. */
export const offers = ["flip", "vertex", "edge", "conflicts", "line", "stage"] as const;
export type Offer = (typeof offers)[number];

/** How many numbers an offer needs. */
export const needs: Record<Offer, 0 | 1 | 2> = {
  flip: 0,
  vertex: 1,
  edge: 2,
  conflicts: 1,
  line: 1,
  stage: 0,
};

/** Makes the condition; null if a number is missing or is no number of a vertex or line. */
export function conditionOf(offer: Offer, first: number, second: number): Condition | null {
  const isWhole = (value: number) => Number.isInteger(value) && value >= 0 && value < 0xffffffff;
  switch (offer) {
    case "flip":
    case "stage":
      return { kind: offer };
    case "vertex":
      return isWhole(first) ? { vertex: first } : null;
    case "edge":
      return isWhole(first) && isWhole(second) && first !== second ? { edge: [first, second] } : null;
    case "conflicts":
      return Number.isFinite(first) ? { curve: "conflicts", below: first } : null;
    case "line":
      return isWhole(first) && first > 0 && first < 0xffff ? { line: first } : null;
  }
}
