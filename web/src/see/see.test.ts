// Pieces of overlays that draw nothing themselves.

import { expect, test } from "vitest";
import { rank, rowOf } from "../engine/past";
import { type Happening, NONE } from "../engine/protocol";
import { besideEdge } from "./arrows";
import { arcsOf, breakpoint, heightAt } from "./beach";
import { largest, lastTest } from "./circleTests";
import { dualOf } from "./dual";
import { encroachments } from "./encroachments";
import { byHolder } from "./holding";
import { Links, OUTSIDE } from "./links";
import { isSame } from "./same";
import { isPath, stopsOf, walkOf } from "./stops";
import { crowding, inhabitants, settle, surelyIllegal } from "./verdicts";
import { fromFirst, type Waiter, waitersOf } from "./waiters";

const happened = (kind: string, event: Record<string, unknown>): Happening => ({ position: 0, kind, event });

test("a walk goes on where triangles have a common edge", () => {
  const visits = [
    [0, 1, 2],
    [2, 1, 3],
    [7, 8, 9],
  ].map((triangle) => happened("triangle-visited", { triangle }));
  const stops = stopsOf(visits);
  expect(stops.map(({ isLinked }) => isLinked)).toEqual([false, true, false]);
  expect(isPath(stops)).toBe(false);
  expect(isPath(stops.slice(0, 2))).toBe(true);
  const edges = stopsOf(
    [
      [4, 5],
      [5, 6],
      [8, 9],
    ].map((edge) => happened("walk-stepped", { edge })),
  );
  expect(edges.map(({ isLinked }) => isLinked)).toEqual([false, true, false]);
});

test("a walk is over once something is made of what it has found", () => {
  const walk = [happened("point-considered", {}), happened("walk-stepped", { edge: [0, 1] })];
  expect(walkOf(walk)).toEqual(walk.slice(1));
  // What is found, or tested, does not end it.
  expect(walkOf([...walk, happened("orientation-tested", {}), happened("point-located", {})])).toHaveLength(
    1,
  );
  expect(walkOf([...walk, happened("triangle-deleted", {})])).toEqual([]);
  // It may go on after that: along a segment it does.
  const on = happened("walk-stepped", { edge: [1, 2] });
  expect(walkOf([...walk, happened("edge-deleted", {}), on])).toHaveLength(2);
});

test("the last circle test holds until something else is looked at", () => {
  const tested = happened("circle-tested", { triangle: [0, 1, 2], point: 3, answer: "on", is_inside: true });
  expect(lastTest([tested, happened("edge-flipped", {})])).toEqual(tested.event);
  expect(lastTest([tested, happened("edge-examined", {})])).toBeNull();
  expect(lastTest([])).toBeNull();
  expect(largest(Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1), [0, 1, 2, 3])).toBe(2);
});

test("what waits is listed in the order in which it came", () => {
  expect(rowOf({ edge: [4, 5] })).toEqual([4, 5, NONE]);
  expect(rowOf({ vertex: 4 })).toEqual([4, NONE, NONE]);
  expect(rank([70, 0, 12])).toEqual([2, 0, 1]);
  const waiting = { suspects: Uint32Array.of(1, 2, NONE, 3, 4, NONE, 5, 6, NONE) };
  const listed = waitersOf(waiting, { suspects: [2, 0, 1] }, { queue: "suspects", row: [1, 2, NONE] });
  expect(listed.map(({ vertices }) => vertices)).toEqual([
    [5, 6],
    [1, 2],
    [3, 4],
  ]);
  expect(listed.map(({ isNext }) => isNext)).toEqual([false, true, false]);
  const ranks = (rows: Waiter[]) => rows.map((waiter) => waiter.rank);
  const stack = [1, 2, 3, 4].map(
    (rank): Waiter => ({ queue: "suspects", vertices: [rank], rank, isNext: rank === 4 }),
  );
  expect(ranks(fromFirst(stack, 2))).toEqual([4, 3]);
  const queue = stack.map((waiter) => ({ ...waiter, isNext: waiter.rank === 1 }));
  expect(ranks(fromFirst(queue, 2))).toEqual([1, 2]);
});

test("segments are encroached upon by vertices, and by places where one was to be", () => {
  const happening = (kind: string, event: Happening["event"]): Happening => ({ position: 1, kind, event });
  const found = encroachments([
    happening("encroached", { segment: [3, 4], by: 7 }),
    happening("circumcenter-proposed", { triangle: [1, 2, 3], at: [0.5, 2] }),
    happening("circumcenter-rejected", { triangle: [1, 2, 3], edge: [5, 6] }),
    happening("segment-split", { edge: [5, 6], vertex: 8 }),
  ]);
  expect(found).toEqual([
    { segment: [3, 4], by: 7 },
    { segment: [5, 6], by: [0.5, 2] },
  ]);
  expect(encroachments([happening("circumcenter-rejected", { edge: [5, 6] })])).toEqual([]);
});

test("arcs of the beach line meet where they are equally high", () => {
  const sites = Float64Array.of(0, 3, 2, 1, -1, 2);
  const line = 0;
  for (const [p, q] of [
    [0, 1],
    [1, 0],
    [2, 0],
  ]) {
    const x = breakpoint(sites, p, q, line);
    const [left, right] = [p, q].map((site) => heightAt(x, sites[2 * site], sites[2 * site + 1], line));
    expect(left).toBeCloseTo(right, 9);
  }
  // From left to right the arc of a lower site enters and is left again.
  const arcs = arcsOf(sites, [0, 1, 0], line, -10, 10);
  expect(arcs[0].right).toBeLessThan(arcs[1].right);
  expect(arcs[2]).toMatchObject({ site: 0, right: 10 });
  expect(breakpoint(sites, 0, 1, 1)).toBe(2);
});

test("the dual joins circumcenters, and leaves the hull in rays", () => {
  const points = Float64Array.of(0, 0, 4, 0, 4, 3, 0, 3);
  const links = new Links(Uint32Array.of(0, 1, 2, 0, 2, 3));
  const { segments, rays } = dualOf(points, links, () => false);
  expect([...segments]).toEqual([2, 1.5, 2, 1.5]);
  expect(rays.length).toBe(16);
  const downwards = [...rays.subarray(0, 4)];
  expect(downwards).toEqual([2, 1.5, 0, -1]);
  expect(dualOf(points, links, () => true).rays.length).toBe(0);
});

test("who lies in a circle or on it is told, corners and their doubles aside", () => {
  const points = Float64Array.of(0, 0, 2, 0, 0, 2, 2, 2, 1, 1, 9, 9, 0, 0);
  const found = inhabitants(points, [0, 1, 2]);
  expect(found).toEqual({ inside: [4], on: [3] });
  expect(settle(found, [{ side: "inside", counts: "inside" }])).toEqual({ inside: [4, 3], on: [] });
  expect(settle(found, [{ side: "on", counts: "outside" }])).toEqual(found);
});

test("an edge is surely illegal unless it is locked or there is a tie", () => {
  const links = new Links(Uint32Array.of(0, 1, 2, 0, 2, 3));
  const kite = Float64Array.of(0, 0, 2, -0.5, 4, 0, 2, 0.5);
  expect(surelyIllegal(kite, new Uint32Array(), links)).toHaveLength(4);
  expect(surelyIllegal(kite, Uint32Array.of(2, 0), links)).toEqual([]);
  const square = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1);
  expect(surelyIllegal(square, new Uint32Array(), links)).toEqual([]);
});

test("a constraint is crowded by an apex in its diametral circle", () => {
  const points = Float64Array.of(0, 0, 4, 0, 2, 1, 2, -2);
  const links = new Links(Uint32Array.of(0, 1, 2));
  expect([...crowding(points, Uint32Array.of(0, 1), links)]).toEqual([1]);
  expect(links.find(1, 0)).toBe(OUTSIDE);
  expect([...crowding(points, Uint32Array.of(0, 1), new Links(Uint32Array.of(1, 0, 3)))]).toEqual([0]);
});

test("data are gathered by triangle", () => {
  const rows = [0, 1, 2, NONE, NONE, NONE, 0, 1, 2];
  expect(byHolder(rows)).toEqual([{ triangle: [0, 1, 2], data: [0, 2] }]);
});

test("the arrow of a half-edge lies on its left, away from the ends", () => {
  // To the right on the screen: left is up, where y is smaller.
  const arrow = besideEdge([0, 0], [100, 0])!;
  expect(arrow.start[1]).toBeLessThan(0);
  expect(arrow.label[1]).toBeLessThan(arrow.control[1]);
  expect(arrow.start[0]).toBeGreaterThan(0);
  expect(arrow.end[0]).toBeLessThan(100);
  const back = besideEdge([100, 0], [0, 0])!;
  expect(back.start[1]).toBeGreaterThan(0);
  expect(besideEdge([0, 0], [3, 0])).toBeNull();
  expect(besideEdge([0, 0], [Number.NaN, 0])).toBeNull();
});

test("things are wanted anew when one of their parts is another", () => {
  const of = {};
  expect(isSame({ of, x: 1 }, { of, x: 1 })).toBe(true);
  expect(isSame({ of, x: 1 }, { of, x: 2 })).toBe(false);
  expect(isSame({ of, x: 1 }, { of: {}, x: 1 })).toBe(false);
});
