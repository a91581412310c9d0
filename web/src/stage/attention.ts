// What somebody asks the stage to bring into view.

import { signal } from "@preact/signals";
import type { Box } from "./camera";

/** What is to be brought into view next; null once it has been. */
export const attention = signal<Box | null>(null);

/** Brings a box into view, with some of what is around it. */
export function lookAt(box: Box): void {
  attention.value = { ...box };
}

/** Makes a box larger on all sides by a part of another size. */
export function widened({ low, high }: Box, by: number): Box {
  return {
    low: [low[0] - by, low[1] - by],
    high: [high[0] + by, high[1] + by],
  };
}
