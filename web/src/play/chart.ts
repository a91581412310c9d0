// Curves as steps: a value holds until the next one.

/** Pairs of a position and the value from there on, in a row. */
export type Samples = Float64Array;

/** Returns the value that holds at a position; undefined before the first one. Logarithmic. */
export function valueAt(samples: Samples, position: number): number | undefined {
  let [low, high] = [0, samples.length / 2];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (samples[2 * middle] <= position) low = middle + 1;
    else high = middle;
  }
  return low > 0 ? samples[2 * low - 1] : undefined;
}

/** Returns the lowest and the highest value. */
export function extent(samples: Samples): [low: number, high: number] {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = 1; i < samples.length; i += 2) {
    low = Math.min(low, samples[i]);
    high = Math.max(high, samples[i]);
  }
  return [low, high];
}

/** Writes the curve as a path in a box of this size, y downwards; it ends at the run's end. */
export function pathOf(samples: Samples, length: number, width: number, height: number): string {
  const [low, high] = extent(samples);
  const x = (position: number) => short((position / Math.max(1, length)) * width);
  const y = (value: number) => short(height - ((value - low) / (high - low || 1)) * height);
  const parts: string[] = [];
  for (let i = 0; i < samples.length; i += 2) {
    parts.push(i === 0 ? `M${x(samples[0])} ${y(samples[1])}` : `H${x(samples[i])}V${y(samples[i + 1])}`);
  }
  return parts.length > 0 ? `${parts.join("")}H${short(width)}` : "";
}

const short = (value: number) => Math.round(value * 100) / 100;
