// Figures of races, written.

import { number } from "../words";

/** Writes milliseconds: times are never known better than to three digits. */
export const milliseconds = (value: number): string => number(value, 3);
