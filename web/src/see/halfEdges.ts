// The half-edges of the edge under the pointer, and where their pointers lead: the algebra of a mesh.

import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";
import { pickerOf } from "../stage/picking";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { pointer } from "../stage/tool";
import { besideEdge, drawArrow } from "./arrows";
import { OUTSIDE } from "./links";
import { chip } from "./looks";
import { type Pointer, pointersOf } from "./pointers";
import { linksOf, type Shown, shown } from "./shown";

/** Where along the arrows their names stand: in a narrow triangle not upon each other. */
const shares: Record<Pointer, number> = {
  h: 0.55,
  twin: 0.55,
  next: 0.38,
  prev: 0.38,
  onext: 0.62,
  oprev: 0.7,
};

/** Draws the half-edge on the side of the pointer, and the others that it knows. */
export const halfEdges: Overlay = (pen) => {
  const scene = shown.value;
  const at = pointer.value;
  if (!scene || !at) return;
  // Arrows along an edge beyond the view nobody would see.
  const reach = at.pixel * Math.hypot(pen.size.width, pen.size.height);
  const edge = pickerOf(scene).edge(at.x, at.y, reach);
  if (edge === null) return;
  const [from, to] = towards(scene, edge, at.x, at.y);
  const colours = coloursOf(pen);
  const links = linksOf(scene);
  pen.polygon(scene.points, [from, to], { stroke: pale(pen.palette.ink, 0.25), width: 5 });
  const h = links.find(from, to);
  if (h !== OUTSIDE) {
    const corners = [from, to, links.apex(h)];
    pen.polygon(scene.points, corners, { fill: pale(colours.h, 0.12) });
  }
  pen.dot(...placeOf(scene.points, from), { stroke: colours.h, width: 2.5, size: 7 });
  for (const [name, ends] of Object.entries(pointersOf(links, from, to)) as [Pointer, [number, number]][]) {
    const [start, end] = ends.map((v) => pen.at(...placeOf(scene.points, v)));
    const arrow = besideEdge(start, end, shares[name]);
    if (!arrow) continue;
    drawArrow(pen, arrow, colours[name], name === "h" ? 3.5 : 2);
    chip(pen, ...(arrow.label as [number, number]), name, colours[name], name === "h");
  }
};

/** Turns an edge so that a place lies on its left. */
function towards({ points, edges }: Shown, edge: number, x: number, y: number): [number, number] {
  const [a, b] = edges.subarray(2 * edge, 2 * edge + 2);
  const [ax, ay, bx, by] = [...placeOf(points, a), ...placeOf(points, b)];
  return (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0 ? [a, b] : [b, a];
}

function coloursOf({ palette }: Pen): Record<Pointer, string> {
  const { asked, sweep, good, front } = palette;
  return { h: asked, twin: sweep, next: good, prev: good, onext: front, oprev: front };
}
