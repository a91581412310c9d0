// Errors on their way from the worker to the page: Comlink carries message and name alone, and these tell where the
// trouble is, too.

import { transferHandlers } from "comlink";
import type { Marks } from "./protocol";

/** What Comlink makes of an error, to be carried. */
interface Carried {
  isError: boolean;
  value: object;
}

/** Makes errors carry what they mark; called once, in the worker. */
export function carryMarks(): void {
  const usual = transferHandlers.get("throw")!;
  transferHandlers.set("throw", {
    ...usual,
    serialize(thrown) {
      const [carried, transfer] = usual.serialize(thrown) as [Carried, Transferable[]];
      const marks = marksOf((thrown as { value: unknown }).value);
      const value = carried.isError ? { ...carried.value, ...marks } : carried.value;
      return [{ ...carried, value }, transfer];
    },
  });
}

/** Returns what an error marks; nothing if it says nothing of that kind. */
export function marksOf(error: unknown): Marks | undefined {
  if (!(error instanceof Error) || !("places" in error)) return undefined;
  const { places, segments, points, line } = error as Error & Marks;
  return { places, segments, points, line };
}
