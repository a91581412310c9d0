// The command line that gives the same mesh.

import type { DrawingAbout, MeshKind, MeshOptions, Preset, Recipe, Rule } from "../engine/protocol";
import { USUAL_LIMIT } from "./estimate";

/** What is asked, and of what. */
export interface Asked {
  recipe: Recipe;
  about: DrawingAbout;
  /** What kind of drawings presets are, by name. */
  presets: readonly Preset[];
  kind: MeshKind;
  options: MeshOptions;
  /** Whether the limit of vertices was reached. */
  isLimited: boolean;
}

export interface Command {
  lines: string[];
  /** The file that has to be saved from here first; null if the command has all that it needs. */
  save: string | null;
}

/** Writes the command; null if there is none: the program never leaves segments aside. */
export function commandOf(asked: Asked): Command | null {
  const { kind, about } = asked;
  if (kind === "triangulate" && about.segments + about.holes > 0) return null;
  const input = inputOf(asked);
  const verb = kind === "refine" ? "mesh" : "triangulate";
  const output = `${input.file.replace(/\.[^.]*$/, "")}-mesh.vtu`;
  const words = ["delone", verb, quoted(input.file), ...flags(asked, input.rule), "-o", quoted(output)];
  return { lines: [...input.lines, words.join(" ")], save: input.save };
}

interface Input {
  file: string;
  lines: string[];
  save: string | null;
  /** Which triangles are kept of this file unless something else is asked for. */
  rule: Rule;
}

function inputOf({ recipe: { source, edits }, about, presets }: Asked): Input {
  const hasDomain = about.segments + about.holes > 0;
  const ofPoly: Rule = about.segments > 0 ? "carve" : "hull";
  if (source.kind === "preset" && edits.length === 0) {
    const preset = presets.find(({ name }) => name === source.name);
    const file = `${source.name}.${preset?.kind === "points" ? "csv" : "poly"}`;
    const size = preset?.sized === false ? "" : ` -n ${source.count} --seed ${source.seed}`;
    return { file, lines: [`delone sample ${source.name}${size} -o ${file}`], save: null, rule: ofPoly };
  }
  // A mesh that is opened is refined as a mesh by the program, and as a drawing here.
  if (source.kind === "files" && edits.length === 0 && about.triangles === 0) {
    return { file: source.files[0].name, lines: [], save: null, rule: about.rule };
  }
  const name = source.kind === "preset" ? source.name : "drawing";
  const file = `${name}.${hasDomain ? "poly" : "csv"}`;
  return { file, lines: [], save: file, rule: ofPoly };
}

function flags({ kind, options, about, isLimited }: Asked, usual: Rule): string[] {
  if (kind === "triangulate") return [];
  const rule = options.domain ?? about.rule;
  const flags: string[] = [];
  if (kind === "refine") flags.push(...refining(options, isLimited));
  if (rule !== usual) flags.push("--domain", rule);
  if (options.crossings === "split") flags.push("--crossings", "split");
  return flags;
}

function refining(options: MeshOptions, isLimited: boolean): string[] {
  const { minAngle = 0, maxEdge, maxArea, regionAreas, smoothing, conforming, thesis } = options;
  const flags = ["--min-angle", String(minAngle)];
  if (maxEdge) flags.push("--max-edge", String(maxEdge));
  if (maxArea) flags.push("--max-area", String(maxArea));
  if (regionAreas) flags.push("--area-per-region");
  if (smoothing) flags.push("--smooth", String(smoothing));
  if (conforming) flags.push("--conforming");
  if (thesis) flags.push("--strategy", "thesis");
  // Here there always is a limit; as long as it is not reached, that changes nothing.
  const limit = options.maxVertices ?? (isLimited ? USUAL_LIMIT : undefined);
  if (limit) flags.push("--max-vertices", String(limit));
  return flags;
}

/** Quotes what a shell would take apart. */
const quoted = (word: string): string =>
  /^[\w./+-]+$/.test(word) && !word.startsWith("-") ? word : `'${word.replaceAll("'", "'\\''")}'`;
