// Which algorithm wants to know what.

import type { Algorithm, RunOptions } from "../engine/protocol";

/** Lists the options that make a difference to an algorithm. */
export function wants({ name, takes }: Pick<Algorithm, "name" | "takes">): (keyof RunOptions)[] {
  if (takes === "data") return ["dataPerTriangle"];
  if (name === "thesis" || name === "refinement") return ["minAngle", "maxEdge", "domain"];
  if (takes === "domain") return ["domain"];
  return name === "random-incremental" ? ["seed"] : [];
}

/** Says what is taken where nothing is said; undefined: nothing. */
export function usual({ name }: Pick<Algorithm, "name">, option: keyof RunOptions): string | undefined {
  if (option === "minAngle") return "20";
  return option === "maxEdge" && name === "thesis" ? "3" : undefined;
}

/** Tells whether an algorithm is about angles. */
export const isAboutAngles = (of: Pick<Algorithm, "name" | "takes">): boolean =>
  wants(of).includes("minAngle");

/** Puts an option, or takes it away if there is no number. */
export function withOption(options: RunOptions, name: keyof RunOptions, value: unknown): RunOptions {
  const { [name]: _, ...others } = options;
  const isNone = value === undefined || value === "" || Number.isNaN(value);
  return isNone ? others : { ...others, [name]: value };
}
