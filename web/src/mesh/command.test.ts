import { expect, test } from "vitest";
import type { DrawingAbout, Preset, Source } from "../engine/protocol";
import { type Asked, commandOf } from "./command";

const about: DrawingAbout = {
  points: 9,
  segments: 9,
  holes: 1,
  regions: 0,
  triangles: 0,
  rule: "carve",
  attributes: [],
  leftOut: [],
};
const presets: Preset[] = [
  { name: "lake", about: "", kind: "scene", sized: false },
  { name: "coast", about: "", kind: "domain", sized: true },
  { name: "uniform", about: "", kind: "points", sized: true },
];
const preset = (name: string) => ({ kind: "preset", name, count: 300, seed: 7 }) as const;
const file = (name: string): Source => ({ kind: "files", files: [{ name, bytes: new Uint8Array() }] });
const bare = { ...about, segments: 0, holes: 0, rule: "hull" as const };

const of = (change: Partial<Asked>) =>
  commandOf({
    recipe: { source: preset("lake"), edits: [] },
    about,
    presets,
    kind: "refine",
    options: {},
    isLimited: false,
    ...change,
  });

test("presets are written by the program itself", () => {
  expect(of({ options: { minAngle: 30, maxEdge: 0.25 } })?.lines).toEqual([
    "delone sample lake -o lake.poly",
    "delone mesh lake.poly --min-angle 30 --max-edge 0.25 -o lake-mesh.vtu",
  ]);
  const recipe = { source: preset("uniform"), edits: [] };
  expect(of({ recipe, about: bare, kind: "triangulate" })?.lines).toEqual([
    "delone sample uniform -n 300 --seed 7 -o uniform.csv",
    "delone triangulate uniform.csv -o uniform-mesh.vtu",
  ]);
});

test("all that is asked for is there", () => {
  const options = {
    domain: "evenodd",
    crossings: "split",
    minAngle: 20,
    maxArea: 1e-7,
    regionAreas: true,
    maxVertices: 5000,
    smoothing: 3,
    conforming: true,
    thesis: true,
  } as const;
  const line = of({ options })?.lines[1];
  expect(line).toContain(
    "--min-angle 20 --max-area 1e-7 --area-per-region --smooth 3 --conforming --strategy thesis --max-vertices 5000",
  );
  expect(line).toContain("--domain evenodd --crossings split");
  expect(of({ options, kind: "constrain" })?.lines[1]).toBe(
    "delone triangulate lake.poly --domain evenodd --crossings split -o lake-mesh.vtu",
  );
  expect(of({ isLimited: true })?.lines[1]).toContain("--max-vertices 1000000");
  // Without a bound the program would take its own.
  expect(of({})?.lines[1]).toContain("--min-angle 0");
});

test("files keep their rule and names are quoted", () => {
  const recipe = { source: file("my lake.geojson"), edits: [] };
  const command = of({ recipe, about: { ...about, rule: "evenodd" }, kind: "constrain" });
  expect(command?.lines).toEqual(["delone triangulate 'my lake.geojson' -o 'my lake-mesh.vtu'"]);
  expect(command?.save).toBeNull();
});

test("what is edited, or was a mesh, has to be saved first", () => {
  const edits = [{ addPoint: [0, 0] as [number, number] }];
  expect(of({ recipe: { source: preset("lake"), edits } })?.save).toBe("lake.poly");
  expect(of({ recipe: { source: file("m.vtu"), edits: [] }, about: { ...about, triangles: 4 } })?.save).toBe(
    "drawing.poly",
  );
  // A `.poly` is carved unless something else is said.
  const drawn = { ...about, rule: "hull" as const };
  expect(of({ recipe: { source: preset("lake"), edits }, about: drawn })?.lines[0]).toContain(
    "--domain hull",
  );
});

test("the program does not leave segments aside", () => {
  expect(of({ kind: "triangulate" })).toBeNull();
});
