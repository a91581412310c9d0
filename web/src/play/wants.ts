// Which algorithm wants to know what.

import type { Algorithm, RunOptions } from "../engine/protocol";

/** Lists the options that make a difference to an algorithm. */
export function wants({ name, takes }: Pick<Algorithm, "name" | "takes">): (keyof RunOptions)[] {
  if (takes === "data") return ["dataPerTriangle"];
  if (name === "thesis") return ["minAngle", "maxEdge", "domain"];
  if (takes === "domain") return ["domain"];
  return name === "random-incremental" ? ["seed"] : [];
}

/** Puts an option, or takes it away if there is no number. */
export function withOption(options: RunOptions, name: keyof RunOptions, value: unknown): RunOptions {
  const { [name]: _, ...others } = options;
  const isNone = value === undefined || value === "" || Number.isNaN(value);
  return isNone ? others : { ...others, [name]: value };
}
