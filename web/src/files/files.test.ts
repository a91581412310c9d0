import { expect, test } from "vitest";
import type { Format } from "../engine/protocol";
import { arrange } from "./arrange";
import { fileName, offered } from "./choices";
import { shownPositions } from "./pace";
import { nameOfText } from "./text";

const named = (...names: string[]) => names.map((name) => ({ name, bytes: new Uint8Array(1) }));
const arranged = (...names: string[]) => {
  const { files, left } = arrange(named(...names));
  return [files.map(({ name }) => name), left];
};

test("what needs others is opened, and these lie beside it", () => {
  expect(arranged("a.node", "A.ele", "a.poly")).toEqual([["A.ele", "a.poly", "a.node"], []]);
  expect(arranged("b.csv", "a.node", "a.poly")).toEqual([["a.poly", "a.node"], ["b.csv"]]);
  expect(arranged("a.points.npy", "a.npy")).toEqual([["a.npy", "a.points.npy"], []]);
});

test("text is known by how it begins", () => {
  expect(nameOfText('  {"type": "Point"}')).toBe("text.geojson");
  expect(nameOfText("polygon ((0 0))")).toBe("text.wkt");
  expect(nameOfText("1;2\n3;4")).toBe("text.csv");
});

const bare = { segments: 0, holes: 0, regions: 0 };
const lines = { ...bare, segments: 1 };

const format = (extension: string, can: Partial<Format>): Format => ({
  extension,
  extensions: [extension],
  what: "",
  reads: true,
  drawing: false,
  points: false,
  mesh: false,
  quadratic: false,
  cells: false,
  report: false,
  run: false,
  ...can,
});

test("formats are offered for what they can hold, with what matters there", () => {
  const all = [
    format("node", { points: true, mesh: true, quadratic: true }),
    format("poly", { points: true, drawing: true, mesh: true }),
    format("png", { drawing: true, points: true, mesh: true, quadratic: true, run: true }),
    format("geojson", { points: true, drawing: true }),
    format("dlog", { run: true }),
  ];
  const list = (...asked: Parameters<typeof offered>) =>
    offered(...asked).map(({ extension, choices }) => [extension, ...choices]);
  expect(list("drawing", all, lines, null)).toEqual([
    ["poly", "oneBased"],
    ["png", "size", "legend"],
    ["geojson"],
  ]);
  expect(list("drawing", all, { ...lines, holes: 1 }, null).map(([name]) => name)).toEqual(["poly", "png"]);
  expect(list("drawing", all, bare, null).map(([name]) => name)).toEqual(["node", "poly", "png", "geojson"]);
  expect(list("mesh", all, lines, null)[0]).toEqual(["node", "oneBased", "quadratic"]);
  expect(list("run", all, lines, "webm")).toEqual([
    ["png", "size", "frames", "changesOnly"],
    ["dlog"],
    ["webm", "size", "seconds"],
  ]);
  expect(list("picture", all, lines, null)).toEqual([["png", "size"]]);
});

test("names suit every file system", () => {
  expect(fileName("lake", "csv")).toBe("lake.csv");
  expect(fileName("../a b:c", "png")).toBe("a-b-c.png");
  expect(fileName("???", "png")).toBe("drawing.png");
  expect(fileName("See Süd", "svg")).toBe("See-Süd.svg");
});

test("a video shows the beginning and the end", () => {
  expect(shownPositions(100, 1, 5)).toEqual([0, 25, 50, 75, 100]);
  expect(shownPositions(3, 1, 7)).toEqual([0, 1, 1, 2, 2, 3, 3]);
  expect(shownPositions(7, 0, 25)).toEqual([0, 7]);
});
