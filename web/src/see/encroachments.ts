// Segments that something is too close to, among what has happened.

import type { Happening } from "../engine/protocol";

/** A segment, and what is too close to it: a vertex, or a place where one was to be. */
export interface Encroachment {
  segment: number[];
  by: number | [x: number, y: number];
}

/** Finds them: segments that were found so, and those on whose account a place was given up. */
export function encroachments(happenings: readonly Happening[]): Encroachment[] {
  const found: Encroachment[] = [];
  let place: [number, number] | undefined;
  for (const { kind, event } of happenings) {
    if (kind === "encroached") found.push({ segment: event.segment as number[], by: event.by as number });
    if (kind === "circumcenter-proposed") place = event.at as [number, number];
    if (kind === "circumcenter-rejected" && place) found.push({ segment: event.edge as number[], by: place });
  }
  return found;
}
