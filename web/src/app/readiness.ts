// Whether the module is there that computes everything, and if not, why.

import { signal } from "@preact/signals";

/** What may be in the way: no WebAssembly, no workers, or something while they were started. */
export type Reason = "wasm" | "workers" | "start";

export interface Failure {
  reason: Reason;
  /** What the browser said. */
  told: string;
}

export const readiness = signal<"loading" | "ready" | Failure>("loading");

/** Tells what the browser lacks; null: nothing. Policies, too, take WebAssembly away. */
export function lacking(): Reason | null {
  if (typeof WebAssembly !== "object") return "wasm";
  if (typeof Worker !== "function") return "workers";
  return null;
}

/** Tells that the module has not come. */
export function fail(reason: Reason, error?: unknown): void {
  readiness.value = { reason, told: error instanceof Error ? error.message : "" };
}
