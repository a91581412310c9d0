// What came of it, by name: a key of `words.mesh.outcomes`.

import type { MeshData } from "../engine/protocol";
import type { Words } from "../words";

export interface Outcome {
  name: keyof Words["mesh"]["outcomes"];
  /** good: all as asked. fair: only the input forbids more. bad: something is missing. */
  tone: "good" | "fair" | "bad";
}

export function outcomeOf({ quality }: Pick<MeshData, "quality">): Outcome {
  const { outcome, triangles, constrainedEdges, unmet, unexcused } = quality;
  if (triangles === 0) return { name: "none", tone: "bad" };
  if (outcome === null) return { name: constrainedEdges > 0 ? "constrained" : "made", tone: "good" };
  const tone = unmet === 0 ? "good" : unexcused === 0 ? "fair" : "bad";
  if (outcome === "budgetExhausted" || outcome === "precisionLimit" || outcome === "fellBack") {
    return { name: outcome, tone };
  }
  return { name: tone === "good" ? "complete" : tone === "fair" ? "excused" : "unexcused", tone };
}
