// Which positions of a run a video shows.

/** Returns the positions that are shown: from the beginning to the end, so many a second. */
export function shownPositions(length: number, seconds: number, perSecond: number): number[] {
  const count = Math.max(2, Math.round(seconds * perSecond));
  return Array.from({ length: count }, (_, i) => Math.round((i / (count - 1)) * length));
}
