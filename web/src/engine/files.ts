// Files that leave the module.

import { transfer } from "comlink";
import { zipSync } from "fflate";
import type { SavedFile } from "../wasm/delone.js";
import type { NamedBytes } from "./protocol";

/** Takes the bytes of saved files out of the module, and hands them over without a copy. */
export function takeFiles(saved: SavedFile[]): NamedBytes[] {
  const files = saved.map((file) => {
    const taken = { name: file.name, bytes: file.bytes() };
    file.free();
    return taken;
  });
  return transfer(
    files,
    files.map((file) => file.bytes.buffer),
  );
}

/** Puts files into one. */
export function zipped(name: string, files: NamedBytes[]): NamedBytes {
  const bytes = zipSync(Object.fromEntries(files.map((file) => [file.name, file.bytes])));
  return transfer({ name, bytes }, [bytes.buffer]);
}
