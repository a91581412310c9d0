// The worker: the Rust module, and what the page may ask of it. Nothing lives here that the page cannot make
// again: whoever cancels ends the worker and starts another one.

import { expose } from "comlink";
import init, { version } from "../wasm/delone.js";
import { drawings } from "./drawings";
import { looks } from "./looks";
import { meshes } from "./meshes";
import { players } from "./players";

const worker = {
  /** Loads the compiled module; before everything else. */
  async start(module: WebAssembly.Module): Promise<string> {
    await init({ module_or_path: module });
    return version();
  },
  drawings,
  players,
  meshes,
  looks,
};

/** What the page may ask. */
export type Worked = typeof worker;

expose(worker);
