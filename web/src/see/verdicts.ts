// What can be said for certain of triangles and edges with rounded numbers: for scenes that nobody judges exactly.

import type { CircleSide, Coordinates, Indices } from "../engine/protocol";
import { sideOfCircle, sideOfDiametral } from "./circles";
import { type Links, OUTSIDE } from "./links";

/**
 * Lists for each constraint whether a corner of its triangles lies in its diametral circle: 1 for certain, 0 on it as
 * far as rounded numbers tell, -1 not. In a constrained Delaunay triangulation no vertex that sees it does then.
 */
export function crowding(points: Coordinates, constrained: Indices, links: Links): Int8Array {
  const found = new Int8Array(constrained.length / 2).fill(-1);
  for (let e = 0; e < found.length; e++) {
    const [a, b] = constrained.subarray(2 * e, 2 * e + 2);
    for (const h of [links.find(a, b), links.find(b, a)]) {
      if (h !== OUTSIDE) found[e] = Math.max(found[e], sideOfDiametral(points, [a, b], links.apex(h)));
    }
  }
  return found;
}

/** Finds the edges that are not locally Delaunay for certain, other than constraints. */
export function surelyIllegal(points: Coordinates, constrained: Indices, links: Links): number[] {
  const locked = new Set<number>();
  for (let e = 0; e < constrained.length; e += 2) {
    for (const h of [
      links.find(constrained[e], constrained[e + 1]),
      links.find(constrained[e + 1], constrained[e]),
    ]) {
      if (h !== OUTSIDE) locked.add(h);
    }
  }
  const found: number[] = [];
  for (let h = 0; h < links.twins.length; h++) {
    const twin = links.twins[h];
    if (twin < h || locked.has(h)) continue;
    const [a, b, c, d] = [links.origin(h), links.dest(h), links.apex(h), links.apex(twin)];
    if (sideOfCircle(points, [a, b, c], d) === 1) found.push(a, b, c, d);
  }
  return found;
}

/** Vertices in a circle for certain, and those on it as far as rounded numbers tell. */
export interface Inhabitants {
  inside: number[];
  on: number[];
}

/** Finds who lies in the circumcircle of a triangle, beside its corners. Linear. */
export function inhabitants(points: Coordinates, corners: Iterable<number>): Inhabitants {
  const found: Inhabitants = { inside: [], on: [] };
  const own = Array.from(corners);
  for (let v = 0; 2 * v < points.length; v++) {
    if (own.includes(v)) continue;
    const side = sideOfCircle(points, own, v);
    if (side === 1) found.inside.push(v);
    // A vertex that lies where a corner does is on every circle through it: nothing new.
    else if (side === 0 && !own.some((w) => isSamePlace(points, v, w))) found.on.push(v);
  }
  return found;
}

const isSamePlace = (points: Coordinates, v: number, w: number): boolean =>
  points[2 * v] === points[2 * w] && points[2 * v + 1] === points[2 * w + 1];

/** Replaces what rounded numbers do not tell by what has been said of it, in the same order. */
export function settle({ inside, on }: Inhabitants, sides: readonly (CircleSide | null)[]): Inhabitants {
  const is = (side: CircleSide["side"]) => on.filter((_, i) => sides[i]?.side === side);
  return { inside: [...inside, ...is("inside")], on: is("on") };
}
