// Draws a lifted scene: the floor with its shadow, facets from far to near, and what the step is about upon them.

import type { Circle } from "../see/circles";
import type { Links } from "../see/links";
import type { Shown } from "../see/shown";
import type { Palette } from "../stage/palette";
import { pale } from "../stage/palette";
import { drawFacets } from "./facets";
import type { Lift } from "./project";

/** What is drawn upon the facets. */
export interface Upon {
  /** Edges that bend the wrong way: four numbers each, of which the first two are the ends. */
  illegal: ArrayLike<number>;
  /** Triangles that the step is about, with their colours. */
  triangles: { corners: readonly number[]; colour: keyof Palette }[];
  /** The last test of a circle: it is a plane section here, and the point lies above or below. */
  test: { circle: Circle; triangle: number[]; point: number; colour: keyof Palette } | null;
}

export interface Sheet {
  context: CanvasRenderingContext2D;
  palette: Palette;
  /** From seen coordinates to pixels. */
  at(x: number, y: number): [number, number];
}

/** Draws everything. */
export function drawLifted(sheet: Sheet, scene: Shown, links: Links, lift: Lift, upon: Upon): void {
  const { context } = sheet;
  context.lineJoin = "round";
  context.lineCap = "round";
  context.setLineDash([]);
  if (lift.posture.lift > 0.02) drawFloor(sheet, scene, lift);
  const seen = lift.seeAll(scene.points);
  drawFacets(sheet, links, seen);
  drawConstraints(sheet, scene, seen);
  for (const { corners, colour } of upon.triangles) {
    polygon(sheet, seen, corners);
    fill(sheet, pale(sheet.palette[colour], 0.55));
  }
  drawBent(sheet, seen, upon.illegal);
  drawDots(sheet, seen);
  if (upon.test) drawTest(sheet, scene, lift, upon.test);
}

function drawFloor(sheet: Sheet, { points, edges }: Shown, lift: Lift): void {
  const floor = lift.seeAll(points, true);
  sheet.context.beginPath();
  for (let e = 0; e < edges.length; e += 2) {
    sheet.context.moveTo(...pixel(sheet, floor, edges[e]));
    sheet.context.lineTo(...pixel(sheet, floor, edges[e + 1]));
  }
  stroke(sheet, pale(sheet.palette.soft, 0.5), 1);
}

function drawConstraints(sheet: Sheet, { constrained }: Shown, seen: Float64Array): void {
  for (let e = 0; e < constrained.length; e += 2)
    polygon(sheet, seen, constrained.subarray(e, e + 2), e === 0);
  if (constrained.length > 0) stroke(sheet, sheet.palette.locked, 2);
}

function drawBent(sheet: Sheet, seen: Float64Array, illegal: ArrayLike<number>): void {
  for (let i = 0; i < illegal.length; i += 4) polygon(sheet, seen, [illegal[i], illegal[i + 1]], i === 0);
  if (illegal.length === 0) return;
  stroke(sheet, pale(sheet.palette.bad, 0.3), 7);
  stroke(sheet, sheet.palette.bad, 2.5);
}

function drawDots(sheet: Sheet, seen: Float64Array): void {
  if (seen.length > 3 * 1500) return;
  sheet.context.fillStyle = sheet.palette.ink;
  for (let v = 0; 3 * v < seen.length; v++) {
    sheet.context.beginPath();
    sheet.context.arc(...pixel(sheet, seen, v), 2.25, 0, 2 * Math.PI);
    sheet.context.fill();
  }
}

/** Draws the section of the paraboloid over the circle, and how far the fourth point lies from its plane. */
function drawTest(sheet: Sheet, { points }: Shown, lift: Lift, test: NonNullable<Upon["test"]>): void {
  const colour = sheet.palette[test.colour];
  const { circle, point } = test;
  sheet.context.beginPath();
  for (let i = 0; i <= 96; i++) {
    const angle = (i * Math.PI) / 48;
    const [u, v] = lift.relative(
      circle.x + circle.radius * Math.cos(angle),
      circle.y + circle.radius * Math.sin(angle),
    );
    const [x, y] = lift.see(u, v, lift.height(u, v));
    sheet.context.lineTo(...sheet.at(x, y));
  }
  fill(sheet, pale(colour, 0.16));
  stroke(sheet, colour, 2);
  const [u, v] = lift.relative(points[2 * point], points[2 * point + 1]);
  const [cu, cv] = lift.relative(circle.x, circle.y);
  const [ru] = lift.relative(circle.x + circle.radius, circle.y);
  const top = lift.see(u, v, lift.height(u, v));
  const foot = lift.see(u, v, lift.height(u, v) - lift.above(u - cu, v - cv, ru - cu));
  sheet.context.beginPath();
  sheet.context.moveTo(...sheet.at(top[0], top[1]));
  sheet.context.lineTo(...sheet.at(foot[0], foot[1]));
  stroke(sheet, colour, 2.5);
  sheet.context.beginPath();
  sheet.context.arc(...sheet.at(top[0], top[1]), 6, 0, 2 * Math.PI);
  fill(sheet, colour);
  stroke(sheet, sheet.palette.paper, 2);
}

function pixel(sheet: Sheet, seen: Float64Array, v: number): [number, number] {
  return sheet.at(seen[3 * v], seen[3 * v + 1]);
}

function polygon(sheet: Sheet, seen: Float64Array, vertices: ArrayLike<number>, isNew = true): void {
  const { context } = sheet;
  if (isNew) context.beginPath();
  context.moveTo(...pixel(sheet, seen, vertices[0]));
  for (let k = 1; k < vertices.length; k++) context.lineTo(...pixel(sheet, seen, vertices[k]));
  if (vertices.length > 2) context.closePath();
}

function fill({ context }: Sheet, colour: string): void {
  context.fillStyle = colour;
  context.fill();
}

function stroke({ context }: Sheet, colour: string, width: number): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
}
