// What waits, put in order.

import { type Frame, NONE, type Queue, queues } from "../engine/protocol";

/** Something that waits. */
export interface Waiter {
  queue: Queue;
  /** One, two or three: a vertex, an edge, a triangle. */
  vertices: number[];
  /** Its place in the order in which they have come, from 1; 0: nobody knows any more. */
  rank: number;
  /** Whether it goes first. */
  isNext: boolean;
}

/** Lists what waits, in the order in which it has come, whose order is not known at the end. */
export function waitersOf(
  waiting: Frame["waiting"],
  ranks: Partial<Record<Queue, number[]>>,
  next: { queue: Queue; row: number[] } | null,
): Waiter[] {
  return queues.flatMap((queue) => {
    const items = waiting[queue] ?? new Uint32Array();
    const row = next?.queue === queue ? next.row : null;
    const waiters = Array.from({ length: items.length / 3 }, (_, i): Waiter => {
      // Spelt out: there may be many thousands, at every frame.
      const [a, b, c] = [items[3 * i], items[3 * i + 1], items[3 * i + 2]];
      const vertices = b === NONE ? [a] : c === NONE ? [a, b] : [a, b, c];
      const isNext = row !== null && a === row[0] && b === row[1] && c === row[2];
      return { queue, vertices, rank: ranks[queue]?.[i] ?? 0, isNext };
    });
    return waiters.toSorted((a, b) => (a.rank || Number.MAX_VALUE) - (b.rank || Number.MAX_VALUE));
  });
}

/** Lists what waits from the end at which it is taken out, and so a stack from its top; at most so many, and in any case what goes first. */
export function fromFirst(waiters: readonly Waiter[], most: number): Waiter[] {
  const first = waiters.findIndex(({ isNext }) => isNext);
  const isStack = 2 * first > waiters.length;
  const ordered = isStack ? waiters.toReversed() : waiters;
  return ordered.filter(({ isNext }, i) => i < most || isNext);
}
