// Saving: whoever has what is to be saved writes it; several files become one if that is asked for.

import { signal } from "@preact/signals";
import { type Client, type Engine, mesher, stage } from "../engine/client";
import type { NamedBytes } from "../engine/protocol";
import { drawingName } from "../state/drawing";
import { work, workHere } from "../state/job";
import { run } from "../state/play";
import { fileName, type Offered, type What } from "./choices";
import { picture } from "./compose";
import { download } from "./download";
import { record } from "./record";

/** What was chosen for a file; only that is used which matters for its format. */
export interface Chosen {
  oneBased: boolean;
  quadratic: boolean;
  legend: boolean;
  changesOnly: boolean;
  size: number;
  seconds: number;
  frames: number;
  /** Several files as one. */
  zip: boolean;
}

/** What was saved last. */
export const saved = signal<What | null>(null);

/** The slot of the run on the stage. */
const SLOT = 0;

/** Saves something; returns whether files have been handed to the browser. What goes wrong is shown. */
export async function save(
  what: What,
  { extension, choices, what: kind }: Offered,
  chosen: Chosen,
): Promise<boolean> {
  const played = what === "run" ? run.peek() : null;
  const stem = played ? `${drawingName.peek()}-${played.algorithm}` : drawingName.peek();
  const name = fileName(stem, extension);
  const options = Object.fromEntries(choices.map((choice) => [choice, chosen[choice]]));
  let files: NamedBytes[] | undefined;
  if (what === "picture") files = await here("save", () => picture(name, chosen.size));
  else if (kind === "video") files = await here("record", (...how) => record(name, chosen, ...how));
  else files = await written(what, name, stem, options, chosen.zip);
  if (!files) return false;
  await download(files);
  saved.value = what;
  return true;
}

async function here(
  job: "save" | "record",
  make: (...how: Parameters<Parameters<typeof workHere>[1]>) => Promise<NamedBytes>,
): Promise<NamedBytes[] | undefined> {
  const file = await workHere(job, make);
  return file && [file];
}

function written(
  what: Exclude<What, "picture">,
  name: string,
  stem: string,
  options: object,
  zips: boolean,
): Promise<NamedBytes[] | undefined> {
  const [client, ask] = writers(name, stem, options)[what];
  return work(client, "save", async (engine) => {
    const files = await ask(engine);
    if (files.length < 2 || !zips) return files;
    return [await engine.zipped(fileName(stem, "zip"), files)];
  });
}

type Writer = [Client, (engine: Engine) => Promise<NamedBytes[]>];

function writers(name: string, stem: string, options: object): Record<Exclude<What, "picture">, Writer> {
  return {
    drawing: [stage, (engine) => engine.drawings.save(name, options)],
    run: [stage, (engine) => engine.players.save(SLOT, name, options)],
    mesh: [mesher, (engine) => engine.meshes.save(name, options)],
    cells: [mesher, (engine) => engine.meshes.saveCells(name, options)],
    report: [mesher, (engine) => engine.meshes.saveReport(name, stem)],
  };
}
