// Why an edge is flipped, and why the other one is not: in sentences, from the exact sign of the test.

import type { Answered, Puzzle, Reason } from "../state/predict";
import type { Words } from "../words";
import { keyOf } from "./edges";

/** Explains an answer. */
export function explain(told: Answered, of: Puzzle, say: Words["predict"]): string {
  const { answer } = of;
  let text = say.flipped(keyOf(answer.edge), keyOf(answer.apexes));
  if (!of.isByCircle) return text + say.decided(of.before);
  text += told.because ? reasonToFlip(told.because, say) : ".";
  if (told.instead && told.verdict === "wrong") text += ` ${reasonToStay(told.instead, say)}`;
  return text;
}

function reasonToFlip(reason: Reason, say: Words["predict"]): string {
  const [c, d] = reason.quad.apexes;
  const edge = keyOf(reason.quad.edge);
  return reason.side === "on" ? say.onInside(edge, d, c) : say.inside(edge, d, c);
}

function reasonToStay({ side, quad }: Reason, say: Words["predict"]): string {
  const [c, d] = quad.apexes;
  return (side === "on" ? say.staysOn : say.stays)(keyOf(quad.edge), d, c);
}
