// The colours of triangles: how good they are, or which of them are meant.

import { computed, effect, signal } from "@preact/signals";
import { measure, measured, mesh } from "../state/mesh";
import { type Axis, axisOf, barOf, count, goodness } from "./axis";

/** Whether triangles have the colours of the measure. */
export const isColoured = signal(true);

/** Which triangles are meant: those of a bar of the histogram, or those that fall short; null: all. */
export const highlight = signal<{ bar: number } | "unmet" | null>(null);

/** The axis of the measure; null while there is nothing to measure. */
export const axis = computed<Axis | null>(() => {
  const now = measured.value;
  return now && axisOf(now.measure, now.values);
});

/** How many triangles each bar counts. */
export const counts = computed<number[]>(() =>
  axis.value && measured.value ? count(axis.value, measured.value.values) : [],
);

/** For each triangle how good it is, from 0 to 1, or −1 if it is to have no colour; null: none has. */
export const shades = computed<Float32Array | null>(() => {
  const [along, now, meant] = [axis.value, measured.value, highlight.value];
  if (!along || !now || (!isColoured.value && meant === null)) return null;
  const isMeant = meaning(along, now.values, meant);
  return now.values.map((value, t) => (isMeant(value, t) ? goodness(along, value) : -1));
});

function meaning(along: Axis, values: Float32Array, meant: typeof highlight.value) {
  if (meant === null) return () => true;
  if (meant !== "unmet") return (value: number) => barOf(along, value) === meant.bar;
  const short = new Uint8Array(values.length);
  for (const t of mesh.value?.unmet ?? []) short[t] = 1;
  return (_: number, t: number) => short[t] === 1;
}

// Bars of another mesh, or of another measure, are others.
effect(() => {
  void [mesh.value, measure.value];
  highlight.value = null;
});
