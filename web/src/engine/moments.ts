// How often something happens in each stretch of a run: what the timeline shows.

/** Counts beyond which a stretch is full, whatever else happens there. */
const FULL = 64;

/**
 * Counts in equal stretches of positions 1 to `length`; `next` finds the next moment after a position.
 *
 * At most `FULL` for each stretch, so that a run of millions of steps takes no longer than one of thousands.
 */
export function countMoments(
  next: (from: number) => number | undefined,
  length: number,
  stretches: number,
): Uint32Array {
  const counts = new Uint32Array(stretches);
  const stretch = (position: number) => Math.floor(((position - 1) * stretches) / length);
  const begin = (of: number) => Math.ceil((of * length) / stretches);
  let moment = length > 0 ? next(0) : undefined;
  while (moment !== undefined) {
    const of = stretch(moment);
    counts[of] += 1;
    const isFull = counts[of] >= FULL;
    moment = next(isFull ? Math.max(moment, begin(of + 1)) : moment);
  }
  return counts;
}
