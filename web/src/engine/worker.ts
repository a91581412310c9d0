// The worker: the Rust module, and what the page may ask of it. Nothing lives here that the page cannot make
// again: whoever cancels ends the worker and starts another one.

import { expose } from "comlink";
import init, { version } from "../wasm/delone.js";
import { drawings } from "./drawings";
import { zipped } from "./files";
import { meshes } from "./meshes";
import { players } from "./players";
import { carryMarks } from "./troubles";

const worker = {
  /** Loads the compiled module; before everything else. */
  async start(module: WebAssembly.Module): Promise<string> {
    await init({ module_or_path: module });
    return version();
  },
  drawings,
  players,
  meshes,
  zipped,
};

/** What the page may ask. */
export type Worked = typeof worker;

carryMarks();
expose(worker);
