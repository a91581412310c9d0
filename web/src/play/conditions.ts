// What conditions of breakpoints are called.

import type { Condition } from "../engine/protocol";
import { number, words } from "../words";
import { sayKind } from "./described";

/** Says what stops. */
export function sayCondition(condition: Condition): string {
  const { said } = words.value.play.breakpoints;
  const { names } = words.value.play.curves;
  if ("kind" in condition) {
    if (condition.kind === "flip") return said.flip;
    return condition.kind === "stage" ? said.stage : said.kind(sayKind(condition.kind));
  }
  if ("line" in condition) return said.line(condition.line);
  if ("vertex" in condition) return said.vertex(condition.vertex);
  if ("edge" in condition) return said.edge(...condition.edge);
  if ("stage" in condition) return said.stage;
  const what = names[condition.curve];
  return "below" in condition
    ? said.below(what, number(condition.below))
    : said.above(what, number(condition.above));
}
