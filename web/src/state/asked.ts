// What of the options counts: some say nothing about some kinds of meshes.

import type { MeshKind, MeshOptions } from "../engine/protocol";

const ofDomains = ["domain", "crossings"] as const;
const ofThesis = [...ofDomains, "minAngle", "maxEdge", "maxVertices", "thesis"] as const;

/** Returns the options that count for a kind of meshes: the strategy of the thesis knows fewer than the usual one. */
export function counting(kind: MeshKind, options: MeshOptions): MeshOptions {
  if (kind === "triangulate") return {};
  if (kind === "constrain") return pick(options, ofDomains);
  return options.thesis ? pick(options, ofThesis) : options;
}

function pick(options: MeshOptions, names: readonly (keyof MeshOptions)[]): MeshOptions {
  return Object.fromEntries(
    Object.entries(options).filter(([name]) => names.includes(name as keyof MeshOptions)),
  );
}
