// The page's ends of its two workers: one for the stage, one for meshes, so that neither waits for the other. The
// module is compiled once; a worker that is at work can be ended at any moment, and the next one gets the compiled
// module at once.

import { proxy, wrap } from "comlink";
import wasm from "../wasm/delone_bg.wasm?url";
import { GONE } from "./gone";
import type { Progress } from "./protocol";
import type { Worked } from "./worker";

/** Why work has no result: somebody has cancelled it. */
export class Cancelled extends Error {
  constructor() {
    super("cancelled");
    this.name = "Cancelled";
  }
}

/** The same functions, answered later. */
type Later<Room> = {
  [Name in keyof Room]: Room[Name] extends (...args: infer Args) => infer Answer
    ? (...args: Args) => Promise<Awaited<Answer>>
    : Later<Room[Name]>;
};

/** What the page may ask of a worker. */
export type Engine = Later<Worked>;

interface Living {
  engine: Engine;
  /** Fulfilled when the worker has the module, and what the worker before had. */
  ready: Promise<void>;
  /** Never fulfilled; rejected when the worker ends. */
  end: Promise<never>;
  kill(): void;
}

/** The compiled module. What goes wrong with it is told to whoever asks something of a worker. */
const module = compile();
module.catch(() => {});

async function compile(): Promise<WebAssembly.Module> {
  const answer = await fetch(wasm);
  if (!answer.ok) throw new Error(`${answer.status} ${wasm}`);
  // Some hosts do not know the type of modules, without which none is compiled while it comes.
  if (answer.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(answer);
  return WebAssembly.compile(await answer.arrayBuffer());
}

/** A worker that may be ended and comes back. */
export class Client {
  private living: Living | undefined;
  private readonly restores: ((engine: Engine) => Promise<void>)[] = [];

  /** Says how a new worker gets what the one before had; done, in order, before anything else is asked of it. */
  onRestart(restore: (engine: Engine) => Promise<void>): void {
    this.restores.push(restore);
  }

  /** Asks something of the worker. Rejected with `Cancelled` when somebody calls `cancel` meanwhile. */
  async ask<T>(question: (engine: Engine) => Promise<T>): Promise<T> {
    const living = this.living ?? this.start();
    this.living = living;
    const { engine, ready, end } = living;
    await Promise.race([ready, end]);
    try {
      return await Promise.race([question(engine), end]);
    } catch (error) {
      // A trap leaves the module in no state to go on with.
      if (error instanceof Error && error.name === "RuntimeError") this.drop(living);
      if (error instanceof Error && error.message === GONE) throw new Cancelled();
      throw error;
    }
  }

  /** Asks as often as somebody calls `cancel` meanwhile: for what the page cannot do without, whoever does what. */
  async insist<T>(question: (engine: Engine) => Promise<T>): Promise<T> {
    for (;;) {
      try {
        return await this.ask(question);
      } catch (error) {
        if (!(error instanceof Cancelled)) throw error;
      }
    }
  }

  /** Ends whatever the worker is doing, at once, be it its beginning. The next question starts another worker. */
  cancel(): void {
    if (this.living) this.drop(this.living);
  }

  private drop(living: Living): void {
    if (this.living === living) this.living = undefined;
    living.kill();
  }

  private start(): Living {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    // Comlink does rooms of functions, but its types do not.
    const engine = wrap(worker) as unknown as Engine;
    let kill = () => {};
    const end = new Promise<never>((_, reject) => {
      kill = () => {
        worker.terminate();
        reject(new Cancelled());
      };
    });
    end.catch(() => {});
    const living = { engine, ready: this.furnish(worker, engine), end, kill };
    // What could not be started is tried anew by the next question.
    living.ready.catch(() => this.drop(living));
    return living;
  }

  private async furnish(worker: Worker, engine: Engine): Promise<void> {
    // A worker that cannot be loaded says so here and answers nothing.
    const broken = new Promise<never>((_, reject) => {
      worker.addEventListener("error", ({ message }) => reject(new Error(message || "worker")));
    });
    broken.catch(() => {});
    await Promise.race([module.then((compiled) => engine.start(compiled)), broken]);
    for (const restore of this.restores) await restore(engine);
  }
}

/** The worker that keeps the drawing and the runs. */
export const stage = new Client();

/** The worker that keeps the mesh. */
export const mesher = new Client();

/** Wraps a function that is told of progress, for the way to a worker. */
export function told(progress: Progress): Progress {
  return proxy(progress);
}
