// Recipes of drawings as text that fits into an address: bytes, deflated, in the letters of base64 that need no escape.
//
// The bytes: the length of a head, the head as JSON, then what it counts: lists of numbers, or files. Edits stay edits:
// to make them again on what they were made on keeps what files and presets have besides points and segments.

import type { Edit, Recipe, Source } from "../engine/protocol";

/** Text longer than this is too much for an address. */
const MOST_TEXT = 8192;

/** Bytes that text of that length may stand for at most: what unpacks to more was not packed here. */
const MOST_BYTES = 1 << 22;

interface Head {
  preset?: [name: string, count: number, seed: number];
  /** Numbers of points, segments and holes; or names and lengths of files. */
  lists?: [points: number, segments: number, holes: number];
  files?: [name: string, length: number][];
  edits: Edit[];
}

/** Packs a recipe; null if that is too long. */
export async function pack(recipe: Recipe): Promise<string | null> {
  const bytes = toBytes(recipe);
  if (bytes.length > MOST_BYTES) return null;
  const text = toText(await through(bytes, new CompressionStream("deflate-raw"), MOST_BYTES));
  return text.length <= MOST_TEXT ? text : null;
}

/** Unpacks a recipe; fails if it is broken. */
export async function unpack(text: string): Promise<Recipe> {
  return fromBytes(await through(fromText(text), new DecompressionStream("deflate-raw"), MOST_BYTES));
}

/** Writes a recipe as bytes. */
export function toBytes({ source, edits }: Recipe): Uint8Array {
  const [head, parts] = split(source);
  const json = new TextEncoder().encode(JSON.stringify({ ...head, edits } satisfies Head));
  const all = [new Uint8Array(new Uint32Array([json.length]).buffer), json, ...parts.map(bytesOf)];
  const bytes = new Uint8Array(all.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of all) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** Reads a recipe from bytes; fails if they are not those of one. */
export function fromBytes(bytes: Uint8Array): Recipe {
  let at = 0;
  const take = (length: number) => {
    if (!Number.isInteger(length) || length < 0 || at + length > bytes.length) throw new Error("too short");
    at += length;
    // A copy: views of wider numbers must begin at multiples of their size.
    return bytes.slice(at - length, at);
  };
  const length = new Uint32Array(take(4).buffer)[0];
  const { preset, lists, files, edits }: Head = JSON.parse(new TextDecoder().decode(take(length)));
  if (!Array.isArray(edits)) throw new Error("no edits");
  if (preset) {
    const [name, count, seed] = preset;
    return {
      source: { kind: "preset", name: String(name), count: Number(count), seed: Number(seed) },
      edits,
    };
  }
  if (lists) {
    const [points, segments, holes] = lists;
    const [a, b, c] = [16 * points, 8 * segments, 16 * holes].map((size) => take(size).buffer);
    const made = {
      points: new Float64Array(a),
      segments: new Uint32Array(b),
      holes: new Float64Array(c),
    };
    return { source: { kind: "lists", ...made }, edits };
  }
  const read = (files ?? []).map(([name, size]) => ({ name: String(name), bytes: take(size) }));
  if (read.length === 0) throw new Error("no files");
  return { source: { kind: "files", files: read }, edits };
}

/** Splits a source into what is said of it and the bytes that follow. */
function split(source: Source): [head: Omit<Head, "edits">, parts: ArrayBufferView[]] {
  switch (source.kind) {
    case "preset":
      return [{ preset: [source.name, source.count, source.seed] }, []];
    case "files": {
      const files = source.files.map(({ name, bytes }): [string, number] => [name, bytes.length]);
      return [{ files }, source.files.map(({ bytes }) => bytes)];
    }
    case "lists": {
      const { points, segments, holes } = source;
      const lists: Head["lists"] = [points.length / 2, segments.length / 2, holes.length / 2];
      return [{ lists }, [points, segments, holes]];
    }
  }
}

const bytesOf = ({ buffer, byteOffset, byteLength }: ArrayBufferView): Uint8Array =>
  new Uint8Array(buffer, byteOffset, byteLength);

/** Sends bytes through a stream; fails if more than `most` come out. */
async function through(bytes: Uint8Array, stream: GenericTransformStream, most: number): Promise<Uint8Array> {
  const source = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream();
  const reader = source
    .pipeThrough<Uint8Array>(stream as TransformStream<Uint8Array, Uint8Array>)
    .getReader();
  const parts: Uint8Array[] = [];
  for (let total = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    total += value.length;
    if (total > most) {
      await reader.cancel();
      throw new Error("too long");
    }
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts as Uint8Array<ArrayBuffer>[]).arrayBuffer());
}

/** Writes bytes in the letters of base64url. */
export function toText(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** Reads bytes from the letters of base64url; fails for any other letter. */
export function fromText(text: string): Uint8Array {
  return Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) =>
    letter.charCodeAt(0),
  );
}
