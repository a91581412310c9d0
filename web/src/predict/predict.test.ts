import { expect, test } from "vitest";
import { innerEdges, keyOf, nearestEdge, type Quad } from "./edges";
import { judge, noScore, OFFERED, offer, scored } from "./game";

// A square 0 1 2 3 with a diagonal 0–2, and a triangle 1 4 2 beside it.
const points = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1, 2, 0);
const scene = {
  triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 1, 4, 2),
  edges: Uint32Array.of(0, 1, 2, 1, 2, 0, 2, 3, 3, 0, 1, 4, 4, 2),
  locked: Uint8Array.of(0, 0, 0, 0, 0, 0, 0),
};

test("inner edges are those with two triangles that are not locked", () => {
  expect(innerEdges(scene)).toEqual([
    { edge: [0, 2], apexes: [1, 3] },
    { edge: [1, 2], apexes: [0, 4] },
  ]);
  const locked = Uint8Array.of(0, 1, 0, 0, 0, 0, 0);
  expect(innerEdges({ ...scene, locked }).map(({ edge }) => edge)).toEqual([[0, 2]]);
});

test("the nearest edge is found within reach", () => {
  const quads = innerEdges(scene);
  expect(nearestEdge(points, quads, 0.4, 0.45, 0.2)?.edge).toEqual([0, 2]);
  expect(nearestEdge(points, quads, 1.05, 0.4, 0.2)?.edge).toEqual([1, 2]);
  expect(nearestEdge(points, quads, 1.5, 0.1, 0.2)).toBeNull();
  // Beyond its end an edge is as far as that.
  expect(nearestEdge(points, quads, -0.3, -0.3, 0.4)).toBeNull();
});

const quads: Quad[] = [];
for (let a = 0; a < 6; a++) for (let b = a + 1; b < 6; b++) quads.push({ edge: [a, b], apexes: [7, 8] });

test("guesses are judged", () => {
  const illegal = new Set(["0–1", "2–3"]);
  expect(judge(quads[0], { edge: [1, 0], apexes: [7, 8] }, illegal)).toBe("right");
  const other = quads.find(({ edge }) => keyOf(edge) === "2–3")!;
  expect(judge(other, quads[0], illegal)).toBe("almost");
  expect(judge(quads[1], quads[0], illegal)).toBe("wrong");
});

test("the score keeps what is right, and streaks without hints", () => {
  let score = noScore;
  for (const [verdict, isHinted] of [
    ["right", false],
    ["right", true],
    ["almost", false],
    ["right", false],
  ] as const)
    score = scored(score, verdict, isHinted);
  expect(score).toEqual({ asked: 4, right: 3, streak: 2, best: 2 });
  expect(scored(score, "wrong", false)).toEqual({ asked: 5, right: 3, streak: 0, best: 2 });
});

test("three are offered, with the right one at no place of its own", () => {
  const places = new Set<number>();
  for (const [seed, answer] of quads.entries()) {
    const three = offer(quads, answer, new Set(["0–1", "4–5"]), seed);
    expect(three).toHaveLength(OFFERED);
    expect(three).toContain(answer);
    expect(three).toEqual(offer(quads, answer, new Set(["0–1", "4–5"]), seed));
    expect(three.some((quad) => quad !== answer && ["0–1", "4–5"].includes(keyOf(quad.edge)))).toBe(true);
    places.add(three.indexOf(answer));
  }
  expect(places.size).toBe(3);
  expect(offer(quads.slice(0, 2), quads[0], new Set(), 1)).toHaveLength(2);
});
