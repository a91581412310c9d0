// The drawing, in the worker.

import { transfer } from "comlink";
import { Drawing, fileKind, formats } from "../wasm/delone.js";
import { takeFiles } from "./files";
import type {
  DrawingAbout,
  DrawingData,
  Edit,
  FileKind,
  Format,
  NamedBytes,
  Preset,
  Recipe,
  SaveOptions,
  Source,
} from "./protocol";

let current: Drawing | undefined;

/** Returns the drawing that there is. */
export function drawing(): Drawing {
  current ??= new Drawing([], [], []);
  return current;
}

export const drawings = {
  presets: (): Preset[] => JSON.parse(Drawing.presets()),

  /** Lists the kinds of files that can be read or written. */
  formats: (): Format[] => JSON.parse(formats()),

  /** Tells what a file may be opened as. */
  kind: (file: NamedBytes): FileKind => fileKind(file.name, file.bytes) as FileKind,

  /** Makes the drawing of a recipe, which takes the place of the one before only if nothing is wrong with it. */
  make(recipe: Recipe): DrawingData {
    drawings.keep(recipe);
    return look(drawing());
  },

  /** The same, without showing it. */
  keep({ source, edits }: Recipe): void {
    const made = from(source);
    if (edits.length > 0) made.edit(JSON.stringify(edits));
    current?.free();
    current = made;
  },

  /** Changes the drawing; all of the edits are made, or none. */
  edit(edits: Edit[]): DrawingData {
    drawing().edit(JSON.stringify(edits));
    return look(drawing());
  },

  /** Writes the drawing; the extension of the name tells the format. */
  save: (name: string, options: SaveOptions): NamedBytes[] =>
    takeFiles(drawing().save(name, JSON.stringify(options))),
};

function from(source: Source): Drawing {
  switch (source.kind) {
    case "preset":
      return Drawing.preset(source.name, source.count, source.seed);
    case "files":
      return Drawing.fromFiles(
        source.files.map(({ name }) => name),
        source.files.map(({ bytes }) => bytes),
      );
    case "lists":
      return new Drawing(source.points, source.segments, source.holes);
  }
}

function look(made: Drawing): DrawingData {
  const about: DrawingAbout = JSON.parse(made.about());
  const [points, segments, holes] = [made.points(), made.segments(), made.holes()];
  const regions = made.regions();
  const buffers = [points, segments, holes, regions].map(({ buffer }) => buffer);
  return transfer({ points, segments, holes, regions, about }, buffers);
}
