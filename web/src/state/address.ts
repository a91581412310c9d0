// The part of the address behind `#`, which tells what the page shows: parameters as in a query. Pure text here; who
// reads and writes the address is in `link.ts`.

import type { MeshKind, MeshOptions, RunOptions } from "../engine/protocol";
import { type Mode, modes } from "./mode";

/** What an address may tell; what it leaves out is as usual. */
export interface Address {
  mode?: Mode;
  /** The drawing: files beside the page, a preset, or its whole recipe, packed. */
  open?: string[];
  preset?: { name: string; count: number; seed: number };
  drawing?: string;
  algorithm?: string;
  run?: RunOptions;
  position?: number;
  kind?: MeshKind;
  mesh?: MeshOptions;
  see?: string[];
}

/** A count is whole and not negative. */
type Kind = "number" | "count" | "boolean" | readonly string[];

const rules = ["hull", "carve", "evenodd"] as const;
const kinds: readonly MeshKind[] = ["triangulate", "constrain", "refine"];

const runOptions: Record<keyof RunOptions, Kind> = {
  seed: "count",
  minAngle: "number",
  maxEdge: "number",
  dataPerTriangle: "count",
  domain: rules,
};

const meshOptions: Record<keyof MeshOptions, Kind> = {
  domain: rules,
  crossings: ["error", "split"],
  minAngle: "number",
  maxEdge: "number",
  maxArea: "number",
  regionAreas: "boolean",
  maxVertices: "count",
  smoothing: "count",
  conforming: "boolean",
  thesis: "boolean",
};

/** Writes an address, without its `#`. */
export function encode(address: Address): string {
  const { mode, open, preset, drawing, algorithm, run, position, kind, mesh, see } = address;
  const parts: string[] = [];
  const put = (key: string, value: unknown) => {
    if (value !== undefined) parts.push(`${key}=${escaped(String(value))}`);
  };
  const putList = (key: string, list?: string[]) => {
    if (list) parts.push(`${key}=${list.map(escaped).join(",")}`);
  };
  put("mode", mode);
  putList("open", open);
  put("preset", preset?.name);
  put("n", preset?.count);
  put("seed", preset?.seed);
  put("drawing", drawing);
  put("algorithm", algorithm);
  for (const key of keysOf(runOptions)) put(`run.${key}`, run?.[key]);
  put("at", position);
  put("kind", kind);
  for (const key of keysOf(meshOptions)) put(`mesh.${key}`, mesh?.[key]);
  putList("see", see);
  return parts.join("&");
}

/** Reads an address, without its `#`, and lists the parts that it does not understand. */
export function decode(text: string): { address: Address; broken: string[] } {
  const address: Address = {};
  const broken: string[] = [];
  // Mail and chat programs escape what they think they should.
  const plain = text.includes("=") ? text : (unescaped(text) ?? text);
  for (const part of plain.split("&").filter((each) => each !== "")) {
    const [, key = "", value = ""] = /^([^=]*)=?(.*)$/s.exec(part) ?? [];
    if (!take(address, key, value)) broken.push(part.slice(0, 40));
  }
  if (address.preset?.name === "") {
    broken.push("preset");
    delete address.preset;
  }
  return { address, broken };
}

/** Takes a part of an address; returns whether it is one. */
function take(address: Address, key: string, raw: string): boolean {
  const [room, option] = key.split(".", 2);
  if (option !== undefined) return takeOption(address, room, option, raw);
  if (key === "open" || key === "see") {
    const list = raw === "" ? [] : raw.split(",").map(unescaped);
    // To open nothing is no wish; to see nothing is one.
    const isWhole = list.every((each) => each !== null && each !== "") && (key === "see" || list.length > 0);
    if (isWhole) address[key] = list as string[];
    return isWhole;
  }
  const value = unescaped(raw);
  return value !== null && value !== "" && takeSimple(address, key, value);
}

function takeSimple(address: Address, key: string, value: string): boolean {
  const number = Number(value);
  const preset = () => {
    address.preset ??= { name: "", count: 40, seed: 1 };
    return address.preset;
  };
  switch (key) {
    case "mode":
      return set(address, "mode", oneOf(modes, value));
    case "kind":
      return set(address, "kind", oneOf(kinds, value));
    case "preset":
      preset().name = value;
      return true;
    case "n":
      if (isCount(number)) preset().count = number;
      return isCount(number);
    case "seed":
      if (isCount(number)) preset().seed = number;
      return isCount(number);
    case "at":
      return set(address, "position", isCount(number) ? number : undefined);
    case "drawing":
    case "algorithm":
      return set(address, key, value);
    default:
      return false;
  }
}

function takeOption(address: Address, room: string, option: string, raw: string): boolean {
  const known: Record<string, Kind> | null =
    room === "run" ? runOptions : room === "mesh" ? meshOptions : null;
  if (!known || !Object.hasOwn(known, option)) return false;
  const value = read(known[option], unescaped(raw) ?? "");
  if (value === undefined) return false;
  Object.assign(address, { [room]: { ...address[room as "run" | "mesh"], [option]: value } });
  return true;
}

function read(kind: Kind, text: string): string | number | boolean | undefined {
  if (kind === "boolean") return text === "true" ? true : text === "false" ? false : undefined;
  if (kind !== "number" && kind !== "count") return oneOf(kind, text);
  const number = Number(text);
  if (text.trim() === "") return undefined;
  return (kind === "count" ? isCount(number) : Number.isFinite(number)) ? number : undefined;
}

const isCount = (value: number) => Number.isInteger(value) && value >= 0 && value <= 0xffffffff;

const oneOf = <T extends string>(all: readonly T[], text: string): T | undefined =>
  all.find((each) => each === text);

function set<K extends keyof Address>(address: Address, key: K, value: Address[K] | undefined): boolean {
  if (value !== undefined) address[key] = value;
  return value !== undefined;
}

const keysOf = <T extends object>(object: T) => Object.keys(object) as (keyof T & string)[];

// Slashes of paths stay readable.
const escaped = (text: string) => encodeURIComponent(text).replaceAll("%2F", "/");

function unescaped(text: string): string | null {
  try {
    return decodeURIComponent(text);
  } catch {
    return null;
  }
}
