// Values of measures, written.

import type { Measure } from "../engine/protocol";
import { number, words } from "../words";

/** Writes an angle. */
export const degrees = (value: number): string => `${number(value, 4)}°`;

/** Writes a length or an area; very small and large ones with a power of ten. */
export const size = (value: number, digits = 4): string =>
  value !== 0 && (Math.abs(value) < 1e-4 || Math.abs(value) >= 1e7)
    ? value.toExponential(digits - 1).replace(".", decimalPoint())
    : number(value, digits);

/** Writes a value of a measure, in as few digits as an axis needs. */
export function written(measure: Measure, value: number): string {
  if (measure === "minAngle" || measure === "maxAngle") return `${number(value, 3)}°`;
  return size(value, 2);
}

/** Writes how long something took. */
export function duration(milliseconds: number): string {
  const say = words.value.mesh;
  return milliseconds < 1000
    ? say.milliseconds(number(milliseconds, 2))
    : say.seconds(number(milliseconds / 1000, 3));
}

const decimalPoint = (): string => number(0.5)[1];
