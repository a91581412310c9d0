// What can be shown over the scene. Each overlay is a room of its own; here is the list of them.

import { computed } from "@preact/signals";
import type { Palette } from "../stage/palette";
import type { Overlay } from "../stage/Stage";
import { type Mode, mode } from "../state/mode";
import { type SeeName, switched } from "../state/see";
import { circle } from "./circle";
import { clusters, holders } from "./data";
import { circles, encroached } from "./encroached";
import { front } from "./front";
import { halfEdges } from "./halfEdges";
import { marks } from "./marks";
import { nearest } from "./nearest";
import { numbers } from "./numbers";
import { cocircular, illegal } from "./quads";
import { rays } from "./rays";
import { sweep } from "./sweep";
import { triangle } from "./triangle";
import { dual, voronoi } from "./voronoi";
import { waiting } from "./waiting";
import { walk } from "./walk";

export { type SeeName, switched } from "../state/see";

export const groups = ["step", "structure", "geometry", "pointer"] as const;

/** How a switch looks like what it switches. */
export type Swatch = "area" | "line" | "dash" | "ring" | "dot" | "arrow" | "way" | "number";

export interface Seen {
  name: SeeName;
  group: (typeof groups)[number];
  /** In which modes it has something to show. */
  modes: Mode[];
  swatch: Swatch;
  colour: keyof Palette;
  overlay: Overlay;
}

const play: Mode[] = ["play"];
const scenes: Mode[] = ["play", "mesh"];

/** All that can be switched, in the order in which it is listed. */
export const all: Seen[] = [
  { name: "marks", group: "step", modes: play, swatch: "dot", colour: "good", overlay: marks },
  { name: "circle", group: "step", modes: play, swatch: "ring", colour: "bad", overlay: circle },
  { name: "walk", group: "step", modes: play, swatch: "way", colour: "sweep", overlay: walk },
  { name: "waiting", group: "step", modes: play, swatch: "number", colour: "asked", overlay: waiting },
  { name: "front", group: "step", modes: play, swatch: "arrow", colour: "front", overlay: front },
  { name: "sweep", group: "step", modes: play, swatch: "line", colour: "sweep", overlay: sweep },
  { name: "rays", group: "step", modes: play, swatch: "arrow", colour: "good", overlay: rays },
  { name: "encroached", group: "step", modes: play, swatch: "ring", colour: "bad", overlay: encroached },
  { name: "clusters", group: "step", modes: play, swatch: "ring", colour: "front", overlay: clusters },
  { name: "holders", group: "structure", modes: play, swatch: "way", colour: "locked", overlay: holders },
  {
    name: "numbers",
    group: "structure",
    modes: [...scenes, "predict"],
    swatch: "number",
    colour: "ink",
    overlay: numbers,
  },
  { name: "illegal", group: "structure", modes: scenes, swatch: "dash", colour: "bad", overlay: illegal },
  {
    name: "cocircular",
    group: "structure",
    modes: play,
    swatch: "area",
    colour: "sweep",
    overlay: cocircular,
  },
  { name: "voronoi", group: "geometry", modes: scenes, swatch: "line", colour: "sweep", overlay: voronoi },
  { name: "dual", group: "geometry", modes: scenes, swatch: "line", colour: "front", overlay: dual },
  { name: "circles", group: "geometry", modes: scenes, swatch: "ring", colour: "locked", overlay: circles },
  {
    name: "halfEdges",
    group: "pointer",
    modes: scenes,
    swatch: "arrow",
    colour: "asked",
    overlay: halfEdges,
  },
  { name: "nearest", group: "pointer", modes: scenes, swatch: "way", colour: "sweep", overlay: nearest },
  { name: "triangle", group: "pointer", modes: scenes, swatch: "ring", colour: "good", overlay: triangle },
];

/** In which order they are drawn: what is large first, what is small upon it. */
const order: SeeName[] = [
  "voronoi",
  "dual",
  "cocircular",
  "circles",
  "holders",
  "walk",
  "waiting",
  "front",
  "sweep",
  "illegal",
  "rays",
  "encroached",
  "marks",
  "circle",
  "clusters",
  "numbers",
  "triangle",
  "nearest",
  "halfEdges",
];

const sorted = all.toSorted((a, b) => order.indexOf(a.name) - order.indexOf(b.name));

/** What is drawn over the scene now. */
export const overlays = computed<Overlay[]>(() => {
  const on = sorted.filter(({ name, modes }) => switched.value.has(name) && modes.includes(mode.value));
  return on.map(({ overlay }) => overlay);
});
