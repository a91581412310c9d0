// Which of several files is opened, and which lie beside it.

import type { NamedBytes } from "../engine/protocol";

/** The parts of a mesh, that which needs the others first. */
const family = ["ele", "poly", "node"];

/** What is opened first of all, with what lies beside it; and the names of those that have nothing to do with it. */
export interface Arranged {
  files: NamedBytes[];
  left: string[];
}

/** Arranges files: a mesh before its points, and what has the same name beside it. */
export function arrange(files: NamedBytes[]): Arranged {
  const sorted = files.toSorted((a, b) => rank(a.name) - rank(b.name));
  const stem = stemOf(sorted[0].name);
  const isBeside = ({ name }: NamedBytes) => stemOf(name) === stem;
  return {
    files: sorted.filter(isBeside),
    left: sorted.filter((file) => !isBeside(file)).map(({ name }) => name),
  };
}

/** Of arrays, that of triangles needs that of points. */
function rank(name: string): number {
  if (/\.(points|segments|holes)\.npy$/i.test(name)) return family.length + 1;
  const place = family.indexOf(name.replace(/^.*\./, "").toLowerCase());
  return place < 0 ? family.length : place;
}

function stemOf(name: string): string {
  return name.replace(/(\.(points|segments|holes))?\.[^.]*$/i, "").toLowerCase();
}
