// The finished mesh, in the worker.

import { transfer } from "comlink";
import { type Looker, Mesh } from "../wasm/delone.js";
import { drawing } from "./drawings";
import { takeFiles } from "./files";
import type {
  Explanation,
  Language,
  Measure,
  MeshData,
  MeshKind,
  MeshOptions,
  NamedBytes,
  Nearest,
  Progress,
  SaveOptions,
} from "./protocol";

let current: Mesh | undefined;

/** Returns the mesh that there is. */
function mesh(): Mesh {
  if (!current) throw new Error("there is no mesh yet");
  return current;
}

/** What finds places in the mesh: made when somebody asks first, for it takes a second for a million triangles. */
let looker: Looker | undefined;

function look(): Looker {
  looker ??= mesh().looker();
  return looker;
}

function forgetLooker(): void {
  looker?.free();
  looker = undefined;
}

export const meshes = {
  /** Meshes the drawing; if that fails, the mesh before is still there. */
  make(kind: MeshKind, options: MeshOptions, progress: Progress): MeshData {
    // Its room may be needed; if there is no other mesh in the end, it is made again.
    forgetLooker();
    const begin = performance.now();
    const made = build(kind, options, progress);
    const milliseconds = performance.now() - begin;
    current?.free();
    current = made;
    return shown(made, kind, milliseconds);
  },

  /** Measures every triangle. */
  measures(measure: Measure): Float32Array {
    const values = mesh().measures(measure);
    return transfer(values, [values.buffer]);
  },

  /** Returns the triangle in which a place lies. */
  triangleAt: (x: number, y: number): number | undefined => mesh().triangleAt(x, y),

  /** Finds the vertex nearest to a place; null if there is none. */
  nearest: (x: number, y: number): Nearest | null => JSON.parse(look().nearest(x, y)),

  /** The borders of the Voronoi cells of all vertices, clipped to a box around them: x, y, x, y for each. */
  cells(): Float64Array {
    const cells = look().cells();
    return transfer(cells, [cells.buffer]);
  },

  /** Tells all about a triangle. */
  explain: (triangle: number): Explanation => JSON.parse(mesh().explain(triangle)),

  /** Says in a few sentences why a triangle is as it is. */
  sentence: (triangle: number, language: Language): string => mesh().sentence(triangle, language),

  /** Writes the mesh; the extension of the name tells the format. */
  save: (name: string, options: SaveOptions): NamedBytes[] =>
    takeFiles(mesh().save(name, JSON.stringify(options))),

  /** Writes the report of a refined mesh. */
  saveReport: (name: string, headline: string): NamedBytes[] => takeFiles(mesh().saveReport(name, headline)),

  /** Writes the Voronoi cells. */
  saveCells: (name: string, options: SaveOptions): NamedBytes[] =>
    takeFiles(mesh().saveCells(name, JSON.stringify(options))),
};

function build(kind: MeshKind, options: MeshOptions, progress: Progress): Mesh {
  switch (kind) {
    case "triangulate":
      return Mesh.triangulate(drawing(), progress);
    case "constrain":
      return Mesh.constrain(drawing(), JSON.stringify(options), progress);
    case "refine":
      return Mesh.refine(drawing(), JSON.stringify({ ...options, explains: true }), progress);
  }
}

function shown(made: Mesh, kind: MeshKind, milliseconds: number): MeshData {
  const data: MeshData = {
    kind,
    points: made.points(),
    triangles: made.triangles(),
    edges: made.edges(),
    constrained: made.constrained(),
    locked: new Uint8Array(),
    unmet: made.unmet(),
    hash: made.hash(),
    quality: JSON.parse(made.quality()),
    milliseconds,
  };
  data.locked = lockedOf(data);
  const { points, triangles, edges, constrained, locked } = data;
  return transfer(
    data,
    [points, triangles, edges, constrained, locked].map(({ buffer }) => buffer),
  );
}

/** Marks the edges that are constraints. */
function lockedOf({ points, edges, constrained }: MeshData): Uint8Array {
  const vertices = points.length / 2;
  const key = (a: number, b: number) => Math.min(a, b) * vertices + Math.max(a, b);
  const keys = new Set<number>();
  for (let e = 0; e < constrained.length; e += 2) keys.add(key(constrained[e], constrained[e + 1]));
  const locked = new Uint8Array(edges.length / 2);
  if (keys.size === 0) return locked;
  for (let e = 0; e < edges.length; e += 2) locked[e / 2] = keys.has(key(edges[e], edges[e + 1])) ? 1 : 0;
  return locked;
}
