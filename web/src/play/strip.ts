// The timeline's picture: which pixel stands for which position, and how high its bars are.

/** Half the width of the slider's thumb: its middle stands over the position, so the strip is inset by this. */
export const INSET = 7;

/** Returns the pixel of a position on a strip of this width. */
export const pixelOf = (position: number, length: number, width: number): number =>
  INSET + (length > 0 ? position / length : 0) * (width - 2 * INSET);

/** Returns the position that is nearest to a pixel. */
export function positionAt(pixel: number, length: number, width: number): number {
  const share = (pixel - INSET) / Math.max(1, width - 2 * INSET);
  return Math.round(Math.max(0, Math.min(1, share)) * length);
}

/** A bar: where it begins and ends, as parts of the whole, and its height. */
export interface Bar {
  from: number;
  to: number;
  height: number;
}

/** Makes bars of counts: the highest has height 1, and seldom things are still seen. */
export function bars(counts: ArrayLike<number>): Bar[] {
  const values = Array.from(counts);
  const most = values.reduce((a, b) => Math.max(a, b), 0);
  return values.flatMap((value, i) =>
    value > 0
      ? { from: i / values.length, to: (i + 1) / values.length, height: Math.sqrt(value / most) }
      : [],
  );
}
