// How many points or segments a preset may have.

import type { Preset } from "../engine/protocol";

export interface Bounds {
  least: number;
  most: number;
  /** With how many a preset begins. */
  usual: number;
}

/** More would fill the memory of a page. */
const MOST = 2_000_000;

/** Presets whose segments cross each other nearly all. */
const crossing = new Set(["crossing-segments", "tangle", "lattice-lines"]);

/** Returns the bounds of a preset: points to be watched are few, a domain needs more segments to look like one. */
export function boundsOf({ name, kind }: Preset): Bounds {
  if (crossing.has(name)) return { least: 3, most: 2000, usual: 20 };
  if (name === "square") return { least: 4, most: MOST, usual: 16 };
  return kind === "domain" ? { least: 8, most: MOST, usual: 120 } : { least: 1, most: MOST, usual: 40 };
}

/** Returns the number of a preset that was asked for, within its bounds; its usual one for no number. */
export function within({ least, most, usual }: Bounds, count: number): number {
  return Number.isFinite(count) ? Math.min(most, Math.max(least, Math.round(count))) : usual;
}
