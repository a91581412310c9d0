// Sizes that suit the drawing that is shown, and how many triangles will come.

import { computed } from "@preact/signals";
import { drawing } from "../state/drawing";
import { kind, mesh, options } from "../state/mesh";
import { estimate, extent, suggestions } from "./estimate";

const points = computed(() => drawing.value?.points ?? new Float64Array());

/** A longest edge and a largest area to begin with. */
export const suggested = computed(() => suggestions(points.value));

/** What triangles will cover: as much as those that there are, if there are any, otherwise the box around the drawing. */
const area = computed(() => mesh.value?.quality.area || extent(points.value).area);

/** How many triangles will come; null if only their angles matter. */
export const expected = computed(() =>
  drawing.value ? estimate(drawing.value, area.value, kind.value, options.value) : null,
);
