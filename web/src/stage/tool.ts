// What a pointer does on the stage. Without a tool, or if the tool does not want the gesture, it moves the view.

import { signal } from "@preact/signals";

/** Where a pointer is. */
export interface Place {
  x: number;
  y: number;
  /** The length of a CSS pixel in the plane. */
  pixel: number;
  event: PointerEvent;
}

export interface Tool {
  /** Of the cursor, as style sheets name it. */
  readonly cursor: string;
  /** A pointer goes down; returns whether the gesture is the tool's. */
  down(place: Place): boolean;
  /** A pointer went down, was not wanted, and comes up where it went down. */
  click?(place: Place): void;
  move?(place: Place): void;
  up?(place: Place): void;
  /** The gesture is taken away. */
  cancel?(): void;
}

/** The tool in hand; null: the view is moved. */
export const tool = signal<Tool | null>(null);

/** Where the pointer is in the plane while it hovers over a stage; null elsewhere. */
export const pointer = signal<{ x: number; y: number; pixel: number } | null>(null);

/** Told of clicks on the stage while no tool is in hand; null: nobody. */
export const clicked = signal<((place: Place) => void) | null>(null);
