// The German words for what the library names: nothing is missing, and nothing is left over.

import { existsSync, readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import type { Algorithm } from "../../engine/protocol";
import { initSync, Player } from "../../wasm/delone.js";
import { algorithms } from "./algorithms";
import { steps } from "./steps";

const root = new URL("../../../../", import.meta.url);

let all: Algorithm[] = [];
beforeAll(() => {
  initSync({ module: readFileSync(new URL("web/src/wasm/delone_bg.wasm", root)) });
  all = JSON.parse(Player.algorithms());
});

test("every algorithm is described in German, and in the guide", () => {
  expect(Object.keys(algorithms).sort()).toEqual(all.map(({ name }) => name).sort());
  for (const { name } of all)
    expect(existsSync(new URL(`docs/algorithms/${name}.md`, root)), name).toBe(true);
});

test("every kind of steps has a German name", () => {
  const source = readFileSync(new URL("crates/delone-wasm/src/play/seeking.rs", root), "utf8");
  const kinds = [...source.matchAll(/Event::\w+ \{ \.\. \} => "([\w-]+)"/g)].map(([, kind]) => kind);
  expect(Object.keys(steps).sort()).toEqual(kinds.sort());
});
