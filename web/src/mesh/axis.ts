// What a measure can be, as an axis: where its bars stand, and which of its values are good.

import type { Measure } from "../engine/protocol";

/** How many bars a histogram has. */
const BARS = 30;

export interface Axis {
  low: number;
  high: number;
  /** Whether steps multiply: sizes of a graded mesh differ by powers of ten. */
  isLogarithmic: boolean;
  /** Whether small values are the good ones. */
  isReversed: boolean;
  bars: number;
}

const fixed: Partial<Record<Measure, readonly [number, number]>> = {
  minAngle: [0, 60],
  maxAngle: [60, 180],
  radiusRatio: [0, 1],
};

/** Returns the axis of a measure; of one that may be anything it goes from the least to the largest value there is. */
export function axisOf(measure: Measure, values: Float32Array): Axis {
  const [low, high] = fixed[measure] ?? span(values);
  const isRegion = measure === "region";
  return {
    low,
    high,
    isLogarithmic: fixed[measure] === undefined && !isRegion && low > 0 && high > low,
    isReversed: measure === "maxAngle",
    bars: isRegion ? Math.min(high - low + 1, BARS) : high > low ? BARS : 1,
  };
}

function span(values: Float32Array): [number, number] {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : [0, 0];
}

/** Returns how far along the axis a value is, from 0 to 1. */
export function along({ low, high, isLogarithmic }: Axis, value: number): number {
  if (!(high > low)) return 0;
  const part = isLogarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.max(0, Math.min(part || 0, 1));
}

/** Returns the value so far along the axis. */
export const valueAt = ({ low, high, isLogarithmic }: Axis, part: number): number =>
  isLogarithmic ? low * (high / low) ** part : low + part * (high - low);

/** Returns how good a value is, from 0 to 1. */
export const goodness = (axis: Axis, value: number): number =>
  axis.isReversed ? 1 - along(axis, value) : along(axis, value);

/** Returns the number of the bar in which a value counts. */
export const barOf = (axis: Axis, value: number): number =>
  Math.min(Math.floor(along(axis, value) * axis.bars), axis.bars - 1);

/** Counts values by bars. */
export function count(axis: Axis, values: Float32Array): number[] {
  const counts = new Array<number>(axis.bars).fill(0);
  for (const value of values) counts[barOf(axis, value)] += 1;
  return counts;
}
