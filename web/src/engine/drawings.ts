// The drawing, in the worker.

import { transfer } from "comlink";
import { Drawing } from "../wasm/delone.js";
import { takeFiles } from "./files";
import type { DrawingAbout, DrawingData, NamedBytes, Preset, Recipe, SaveOptions, Source } from "./protocol";

let current: Drawing | undefined;

/** Returns the drawing that there is. */
export function drawing(): Drawing {
  current ??= new Drawing([], [], []);
  return current;
}

export const drawings = {
  presets: (): Preset[] => JSON.parse(Drawing.presets()),

  /** Makes the drawing of a recipe, which takes the place of the one before only if nothing is wrong with it. */
  make(recipe: Recipe): DrawingData {
    drawings.keep(recipe);
    return look(drawing());
  },

  /** The same, without showing it. */
  keep({ source, edits }: Recipe): void {
    const made = from(source);
    if (edits.length > 0) throw new Error("drawings cannot be edited yet");
    current?.free();
    current = made;
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
      return Drawing.fromFile(source.files[0].name, source.files[0].bytes);
    case "lists":
      return new Drawing(source.points, source.segments, source.holes);
  }
}

function look(made: Drawing): DrawingData {
  const about: DrawingAbout = JSON.parse(made.about());
  const [points, segments, holes] = [made.points(), made.segments(), made.holes()];
  return transfer({ points, segments, holes, about }, [points.buffer, segments.buffer, holes.buffer]);
}
