// The finished mesh, in the worker.

import { transfer } from "comlink";
import { Mesh } from "../wasm/delone.js";
import { drawing } from "./drawings";
import { takeFiles } from "./files";
import type { MeshData, MeshKind, MeshOptions, NamedBytes, Progress, SaveOptions } from "./protocol";

let current: Mesh | undefined;

/** Returns the mesh that there is. */
function mesh(): Mesh {
  if (!current) throw new Error("there is no mesh yet");
  return current;
}

export const meshes = {
  /** Meshes the drawing. */
  make(kind: MeshKind, options: MeshOptions, progress: Progress): MeshData {
    current?.free();
    current = undefined;
    const begin = performance.now();
    const made = build(kind, JSON.stringify(options), progress);
    const milliseconds = performance.now() - begin;
    current = made;
    return look(made, kind, milliseconds);
  },

  /** Writes the mesh; the extension of the name tells the format. */
  save: (name: string, options: SaveOptions): NamedBytes[] =>
    takeFiles(mesh().save(name, JSON.stringify(options))),

  /** Writes the report of a refined mesh. */
  saveReport: (name: string, headline: string): NamedBytes[] => takeFiles(mesh().saveReport(name, headline)),

  /** Writes the Voronoi cells. */
  saveCells: (name: string, options: SaveOptions): NamedBytes[] =>
    takeFiles(mesh().saveCells(name, JSON.stringify(options))),
};

function build(kind: MeshKind, options: string, progress: Progress): Mesh {
  switch (kind) {
    case "triangulate":
      return Mesh.triangulate(drawing(), progress);
    case "constrain":
      return Mesh.constrain(drawing(), options, progress);
    case "refine":
      return Mesh.refine(drawing(), options, progress);
  }
}

function look(made: Mesh, kind: MeshKind, milliseconds: number): MeshData {
  const data: MeshData = {
    kind,
    points: made.points(),
    triangles: made.triangles(),
    edges: made.edges(),
    constrained: made.constrained(),
    unmet: made.unmet(),
    hash: made.hash(),
    quality: JSON.parse(made.quality()),
    milliseconds,
  };
  const { points, triangles, edges, constrained } = data;
  return transfer(data, [points.buffer, triangles.buffer, edges.buffer, constrained.buffer]);
}
