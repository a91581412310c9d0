// What can be saved in which format, and what may be said about it there.

import type { Format } from "../engine/protocol";

export const whats = ["drawing", "mesh", "cells", "report", "run", "picture"] as const;
export type What = (typeof whats)[number];

/** Something that may be chosen for a file. */
export type Choice = "oneBased" | "quadratic" | "size" | "legend" | "seconds" | "frames" | "changesOnly";

/** A format as the dialog offers it. */
export interface Offered {
  extension: string;
  /** What it is, in the words of the library; those of the page's own formats are in the words of this room. */
  what: string;
  choices: Choice[];
}

/** What of a drawing a format must be able to hold. */
export interface Content {
  segments: number;
  holes: number;
  regions: number;
}

/** Formats of drawings that cannot hold holes and regions by a place in each. */
const seedless = ["geojson"];

/** Formats that number from nought or from one. */
const numbered = ["node", "ele", "edge", "neigh", "poly"];

/** Lists the formats for something; `video` is the extension of videos that this browser can record, if it can. */
export function offered(what: What, formats: Format[], content: Content, video: string | null): Offered[] {
  if (what === "picture") return [{ extension: "png", what: "png", choices: ["size"] }];
  const rows = formats.filter((format) => can(what, format, content));
  const offers = rows.map((format) => ({
    extension: format.extension,
    what: format.what,
    choices: choicesOf(what, format),
  }));
  const isRecorded = what === "run" && video !== null;
  return isRecorded
    ? [...offers, { extension: video, what: "video", choices: ["size", "seconds"] as Choice[] }]
    : offers;
}

function can(what: Exclude<What, "picture">, format: Format, content: Content): boolean {
  if (what !== "drawing") return format[what];
  const hasSeeds = content.holes + content.regions > 0;
  if (hasSeeds && seedless.includes(format.extension)) return false;
  return hasSeeds || content.segments > 0 ? format.drawing : format.points;
}

function choicesOf(what: What, { extension, quadratic }: Format): Choice[] {
  const isPicture = ["svg", "png", "gif"].includes(extension);
  if (what === "run") {
    if (!isPicture) return [];
    return extension === "png" ? ["size", "frames", "changesOnly"] : ["size", "seconds", "changesOnly"];
  }
  if (what === "report") return [];
  const choices: Choice[] = [];
  if (numbered.includes(extension)) choices.push("oneBased");
  if (what === "mesh" && quadratic && !isPicture) choices.push("quadratic");
  if (isPicture) choices.push("size", "legend");
  return choices;
}

/** Makes a name that every file system takes. */
export const fileName = (name: string, extension: string): string =>
  `${name.replace(/[^\p{L}\p{N}._-]+/gu, "-").replace(/^[-.]+/, "") || "drawing"}.${extension}`;
