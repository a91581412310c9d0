// Where playing stops by itself.

import { computed, signal } from "@preact/signals";
import type { Condition } from "../engine/protocol";

export interface Breakpoint {
  id: number;
  condition: Condition;
  isOn: boolean;
}

/** A breakpoint that has stopped the run, and where. */
export interface Stopped {
  position: number;
  breakpoint: Breakpoint;
}

export const breakpoints = signal<Breakpoint[]>([]);

/** Those that are on. */
export const active = computed(() => breakpoints.value.filter(({ isOn }) => isOn));

/** The breakpoint that has stopped the run last; says nothing once the run stands elsewhere. */
export const stopped = signal<Stopped | null>(null);

let last = 0;

const isSame = (a: Condition, b: Condition) => JSON.stringify(a) === JSON.stringify(b);

/** Adds a breakpoint, unless it is there; then that one is switched on. */
export function addBreakpoint(condition: Condition): void {
  const others = breakpoints.value;
  if (others.some((other) => isSame(other.condition, condition))) {
    breakpoints.value = others.map((other) =>
      isSame(other.condition, condition) ? { ...other, isOn: true } : other,
    );
    return;
  }
  last += 1;
  breakpoints.value = [...others, { id: last, condition, isOn: true }];
}

export function removeBreakpoint(id: number): void {
  breakpoints.value = breakpoints.value.filter((each) => each.id !== id);
}

/** Switches a breakpoint on or off. */
export function switchBreakpoint(id: number): void {
  breakpoints.value = breakpoints.value.map((each) =>
    each.id === id ? { ...each, isOn: !each.isOn } : each,
  );
}

/** Finds the breakpoint on a line of the pseudocode. */
export const onLine = (line: number): Breakpoint | undefined =>
  breakpoints.value.find(({ condition }) => "line" in condition && condition.line === line);

/** Puts a breakpoint on a line, or takes it away. */
export function toggleLine(line: number): void {
  const there = onLine(line);
  if (there) removeBreakpoint(there.id);
  else addBreakpoint({ line });
}

/** Forgets breakpoints on lines: those of another algorithm mean something else. */
export function forgetLines(): void {
  if (breakpoints.peek().some(({ condition }) => "line" in condition))
    breakpoints.value = breakpoints.peek().filter(({ condition }) => !("line" in condition));
}
