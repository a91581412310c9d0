// How fast the module is beside the program on one thread: fastest of some runs each, in turns.
//
//   cargo run -p delone-web-build --release && cargo build -p delone-cli --release && node web/tests/speed.mjs
//
// DELONE names another program than target/release/delone; RUNS another number of runs than 5.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Drawing, initSync, Mesh } from "../src/wasm/delone.js";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const program = process.env.DELONE ?? here("../../target/release/delone");
const runs = Number(process.env.RUNS ?? 5);
const folder = mkdtempSync(join(tmpdir(), "delone-speed-"));
initSync({ module: readFileSync(here("../src/wasm/delone_bg.wasm")) });

const delone = (...args) => execFileSync(program, args, { encoding: "utf8" });

// What of the program's seconds the module's call does as well.
const share = { triangulate: ["triangulate"], mesh: ["triangulate", "constrain", "carve", "refine"] };

function native(command, file, ...args) {
  const { hash, seconds } = JSON.parse(delone(command, file, ...args, "--threads", "1", "--json", "-q"));
  return { hash, ms: 1000 * share[command].reduce((sum, part) => sum + (seconds[part] ?? 0), 0) };
}

function module(build) {
  const begin = performance.now();
  const mesh = build();
  const ms = performance.now() - begin;
  const hash = mesh.hash();
  mesh.free();
  return { hash, ms };
}

function compare(what, ours, theirs) {
  const best = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  for (let run = 0; run < runs; run++) {
    const both = [ours(), theirs()];
    if (both[0].hash !== both[1].hash) throw new Error(`${what}: ${both[0].hash} is not ${both[1].hash}`);
    both.forEach(({ ms }, i) => {
      best[i] = Math.min(best[i], ms);
    });
  }
  const [wasm, plain] = best;
  console.log(`| ${what} | ${wasm.toFixed(0)} ms | ${plain.toFixed(0)} ms | ${(wasm / plain).toFixed(2)} |`);
}

try {
  console.log("| what | module | program | ratio |\n|---|---:|---:|---:|");
  for (const count of [100_000, 1_000_000]) {
    const file = join(folder, `uniform-${count}.npy`);
    delone("sample", "uniform", "-n", String(count), "--seed", "1", "-q", "-o", file);
    const drawing = Drawing.preset("uniform", count, 1);
    compare(
      `triangulate ${count.toLocaleString("en")} uniform points`,
      () => module(() => Mesh.triangulate(drawing)),
      () => native("triangulate", file),
    );
  }
  const lake = join(folder, "lake.poly");
  delone("sample", "lake", "-q", "-o", lake);
  const drawing = Drawing.preset("lake", 0, 1);
  for (const edge of [0.05, 0.015]) {
    compare(
      `mesh the lake, 30°, edges up to ${edge}`,
      () => module(() => Mesh.refine(drawing, JSON.stringify({ minAngle: 30, maxEdge: edge }))),
      () =>
        native("mesh", lake, "--min-angle", "30", "--max-edge", String(edge), "-o", join(folder, "m.npy")),
    );
  }
} finally {
  rmSync(folder, { recursive: true });
}
