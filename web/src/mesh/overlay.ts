// What is drawn over the mesh about the triangle that is asked about: its circle, its corners, and why one of them is there.

import type { Corner, Explanation } from "../engine/protocol";
import { pale } from "../stage/palette";
import type { Pen } from "../stage/pen";
import { placeOf } from "../stage/places";
import type { Overlay } from "../stage/Stage";
import { drawing } from "../state/drawing";
import { mesh } from "../state/mesh";
import { arcBetween, type Spot } from "./arms";
import { corner, told } from "./inspect";
import { degrees } from "./writing";

/** How large an arc is drawn, in pixels. */
const ARC = 34;

/** Triangles smaller than this, in pixels, have no numbers: they would hide it. */
const ROOM = 48;

export const inspection: Overlay = (pen) => {
  const now = told.value;
  const at = corner.value;
  if (!now || !mesh.value) return;
  const { explanation } = now;
  const looked = explanation.vertices[at];
  circle(pen, explanation);
  if (looked.cause) cause(pen, looked, mesh.value.points);
  outline(pen, explanation);
  if (explanation.unmet) angle(pen, explanation);
  const hasRoom = Math.max(...explanation.edges) * pen.camera.scale > ROOM;
  explanation.vertices.forEach((vertex, k) => {
    mark(pen, vertex, k === at, hasRoom);
  });
};

function circle(pen: Pen, { circumcenter, radius }: Explanation): void {
  if (!circumcenter || radius === null) return;
  pen.circle(...circumcenter, radius, { stroke: pen.palette.paper, width: 3.5 });
  pen.circle(...circumcenter, radius, { stroke: pen.palette.sweep, width: 1.5, dash: [6, 4] });
}

function outline(pen: Pen, { vertices }: Explanation): void {
  const spots = vertices.map(({ at }) => at);
  const ring = [...spots, spots[0]];
  pen.path(ring, { stroke: pen.palette.paper, width: 6 });
  pen.path(ring, { stroke: pen.palette.ink, width: 3 });
}

/** Who had to go for this corner, or was divided by it, and who lay too close. */
function cause(pen: Pen, { cause: why }: Corner, points: Float64Array): void {
  if (!why) return;
  const { asked, bad, paper } = pen.palette;
  if (why.parent.length > 2) {
    const ring = [...why.parent, why.parent[0]];
    pen.path(ring, { stroke: paper, width: 4.5 });
    pen.path(ring, { stroke: asked, width: 2.5, dash: [3, 5], fill: pale(asked, 0.15) });
  }
  if (why.edge) {
    pen.path(why.edge, { stroke: paper, width: 6 });
    pen.path(why.edge, { stroke: asked, width: 3.5 });
  }
  if (why.by !== null) {
    const [x, y] = placeOf(points, why.by);
    pen.dot(x, y, { fill: bad, stroke: paper, width: 2, size: 6 });
    pen.label(x, y, String(why.by), bad);
  }
}

/** The angle of the input that leaves no better triangle. */
function angle(pen: Pen, { unmet }: Explanation): void {
  const drawn = drawing.value;
  if (!drawn || !unmet?.segments || unmet.corner === null || unmet.angle === null) return;
  const arc = arcBetween(drawn, unmet.corner, unmet.segments, unmet.angle, ARC / pen.camera.scale);
  if (!arc) return;
  const [middle] = arc.slice(Math.floor(arc.length / 2));
  pen.path(arc, { stroke: pen.palette.paper, width: 5 });
  pen.path(arc, { stroke: pen.palette.bad, width: 2.5 });
  pen.label(...middle, degrees(unmet.angle), pen.palette.bad);
}

function mark(pen: Pen, { vertex, at }: Corner, isLooked: boolean, hasRoom: boolean): void {
  const { ink, paper, asked } = pen.palette;
  const spot: Spot = at;
  pen.dot(...spot, {
    fill: isLooked ? asked : ink,
    stroke: paper,
    width: 2,
    size: (isLooked ? 5 : 3.5) + (hasRoom ? 1 : 0),
  });
  if (hasRoom) pen.label(...spot, String(vertex), ink);
}
