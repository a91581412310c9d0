import { expect, test } from "vitest";
import type { Recipe } from "../engine/protocol";
import { fromBytes, fromText, pack, toBytes, toText, unpack } from "./packing";

const recipes: Recipe[] = [
  { source: { kind: "preset", name: "lake", count: 0, seed: 7 }, edits: [{ movePoint: [3, 0.1, -1e300] }] },
  {
    source: {
      kind: "lists",
      points: Float64Array.of(0, 5e-324, 1 / 3, -0, 1.7976931348623157e308, 6),
      segments: Uint32Array.of(0, 1, 1, 2),
      holes: Float64Array.of(0.5, 0.25),
    },
    edits: [],
  },
  {
    source: {
      kind: "files",
      files: [
        { name: "ä.ele", bytes: Uint8Array.of(1, 2, 255) },
        { name: "ä.node", bytes: new Uint8Array() },
      ],
    },
    edits: [{ clear: true }, { addHole: [1, 2] }],
  },
  {
    source: {
      kind: "lists",
      points: new Float64Array(),
      segments: new Uint32Array(),
      holes: new Float64Array(),
    },
    edits: [],
  },
];

test.each(recipes)("a recipe is the same after packing and unpacking: $source.kind", async (recipe) => {
  const text = await pack(recipe);
  expect(text).toMatch(/^[\w-]+$/);
  expect(await unpack(text!)).toEqual(recipe);
});

test("what does not fit is refused", async () => {
  const points = Float64Array.from({ length: 2000 }, (_, i) => Math.sin(i));
  const source: Recipe["source"] = {
    kind: "lists",
    points,
    segments: new Uint32Array(),
    holes: new Float64Array(),
  };
  expect(await pack({ source, edits: [] })).toBe(null);
});

test("broken bytes fail, and never otherwise", () => {
  const bytes = toBytes(recipes[1]);
  expect(() => fromBytes(bytes.slice(0, -1))).toThrow("too short");
  expect(() => fromBytes(new Uint8Array(2))).toThrow("too short");
  let state = 1;
  for (let round = 0; round < 500; round++) {
    const changed = bytes.slice();
    state = (state * 48271) % 2147483647;
    changed[state % changed.length] ^= 1 + (state % 255);
    try {
      fromBytes(changed);
    } catch (error) {
      expect(error).toBeInstanceOf(Error);
    }
  }
});

test("broken text fails", async () => {
  for (const text of ["!", "AAAA", "7", toText(Uint8Array.of(1, 2, 3))])
    await expect(unpack(text)).rejects.toThrow();
});

test("a little text does not become a lot of bytes", async () => {
  const zeros = new Blob([new Uint8Array(8 << 20)])
    .stream()
    .pipeThrough(new CompressionStream("deflate-raw"));
  const bomb = toText(new Uint8Array(await new Response(zeros).arrayBuffer()));
  await expect(unpack(bomb)).rejects.toThrow("too long");
});

test("bytes are text and bytes again", () => {
  const bytes = Uint8Array.from({ length: 256 }, (_, i) => i);
  expect(fromText(toText(bytes))).toEqual(bytes);
});
