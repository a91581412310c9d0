// The scene that overlays look at, whoever made it.

import { computed } from "@preact/signals";
import type { Coordinates, Indices } from "../engine/protocol";
import { shownMesh } from "../mesh/follow";
import { mode } from "../state/mode";
import { frame, run } from "../state/play";
import { Links } from "./links";

export interface Shown {
  /** The run or the mesh that it belongs to, and where in the run. */
  readonly of: object;
  readonly position: number;
  readonly points: Coordinates;
  readonly edges: Indices;
  readonly triangles: Indices;
  /** The edges that are constraints, two vertices each. */
  readonly constrained: Indices;
}

/** What stands on the stage; null while that is the bare drawing. */
export const shown = computed<Shown | null>(() => (mode.value === "mesh" ? ofMesh() : ofRun()));

/** Whether there is one. */
export const isShown = computed(() => shown.value !== null);

function ofRun(): Shown | null {
  if (!frame.value || !run.value) return null;
  const { position, points, edges, triangles, locked } = frame.value;
  let constrained: Indices | undefined;
  return {
    of: run.value,
    position,
    points,
    edges,
    triangles,
    // Few want to know, and scenes change with each step.
    get constrained() {
      constrained ??= edges.filter((_, i) => locked[i >> 1] === 1);
      return constrained;
    },
  };
}

function ofMesh(): Shown | null {
  const of = shownMesh.value;
  if (!of) return null;
  const { points, edges, triangles, constrained } = of;
  return { of, position: 0, points, edges, triangles, constrained };
}

const known = new WeakMap<Indices, Links>();

/** Returns how the triangles of a scene hang together; computed once for each scene. */
export function linksOf({ triangles }: Shown): Links {
  const links = known.get(triangles) ?? new Links(triangles);
  known.set(triangles, links);
  return links;
}
