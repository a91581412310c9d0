// The deep link: the address always tells what the page shows, and a page opened with it shows that again.

import { batch, effect, signal } from "@preact/signals";
import type { Recipe } from "../engine/protocol";
import { openFetched, originOf } from "../files/fetched";
import { all, type SeeName, switched } from "../see/overlays";
import { words } from "../words";
import { type Address, decode, encode } from "./address";
import { drawing, giveUp, open, recipe, show, usualSource, wish } from "./drawing";
import { kind, options as meshOptions } from "./mesh";
import { mode } from "./mode";
import { notify } from "./notices";
import { pack, unpack } from "./packing";
import { algorithms, chosen, position, run, options as runOptions, seek } from "./play";

/** Milliseconds between two writings of the address: browsers refuse more than a hundred in half a minute. */
const PAUSE = 500;

/** Whether the address tells all; false while the drawing is too large for it. */
export const isLinkable = signal(true);

/** What was written last, to know whether somebody else has changed the address. */
let written = "";

/** Shows what the address tells, its drawing if nobody wishes for another one, and keeps it true from then on. */
export async function beginLink(first: object): Promise<void> {
  await restore(location.hash.slice(1), first);
  addEventListener("hashchange", (event) => {
    // Not `location`: between the change and this event the page may have written its own address there.
    const hash = new URL((event as HashChangeEvent).newURL).hash.slice(1);
    if (hash !== written) void restore(hash);
  });
  keepWriting();
}

/** Returns the address of the page as it is now; null if the drawing is too large for one. */
export async function linkNow(): Promise<string | null> {
  await write();
  return isLinkable.peek() ? location.href : null;
}

async function restore(hash: string, mine: object = wish()): Promise<void> {
  const { address, broken } = decode(hash);
  const names = algorithms.peek().map(({ name }) => name);
  if (address.algorithm !== undefined && !names.includes(address.algorithm)) {
    broken.push(`algorithm=${address.algorithm}`);
    delete address.algorithm;
  }
  batch(() => {
    mode.value = address.mode ?? mode.peek();
    if (address.see) switched.value = seen(address.see, broken);
    if (address.kind) kind.value = address.kind;
    if (address.mesh) meshOptions.value = address.mesh;
    if (address.algorithm) chosen.value = address.algorithm;
    if (address.run) runOptions.value = address.run;
  });
  const isOpen = await openOf(address, broken, mine);
  if (!isOpen) await giveUp(mine);
  if (broken.length > 0) notify("info", words.peek().files.linkBroken(broken.join(", ")));
  if (isOpen) goTo(address.position ?? 0);
}

/** Returns the overlays of these names. */
function seen(names: string[], broken: string[]): ReadonlySet<SeeName> {
  const known = all.map(({ name }) => name);
  broken.push(...names.filter((name) => !known.some((each) => each === name)).map((name) => `see=${name}`));
  return new Set(known.filter((name) => names.includes(name)));
}

/** Opens the drawing of an address, the usual one if it names none. */
async function openOf(
  { open: names, preset, drawing: packed }: Address,
  broken: string[],
  mine: object,
): Promise<boolean> {
  if (names) return openFetched(names, mine);
  if (!packed) return open(preset ? { kind: "preset", ...preset } : usualSource, mine);
  const unpacked = await unpack(packed).catch(() => null);
  if (!unpacked) broken.push("drawing");
  return unpacked !== null && show(unpacked, mine);
}

/** Goes to a position once the run is there. */
function goTo(at: number): void {
  // The run before is given up soon after what it was made of has changed.
  setTimeout(() => {
    const stop = effect(() => {
      if (!run.value) return;
      queueMicrotask(() => stop());
      seek(at);
    });
  });
}

function keepWriting(): void {
  let isWaiting = false;
  effect(() => {
    void [mode.value, recipe.value, chosen.value, runOptions.value, position.value];
    void [kind.value, meshOptions.value, switched.value];
    if (isWaiting) return;
    isWaiting = true;
    setTimeout(() => {
      isWaiting = false;
      void write();
    }, PAUSE);
  });
}

async function write(): Promise<void> {
  const now = recipe.peek();
  const drawn = await tellDrawing(now);
  // While that was packed, something else may have been drawn.
  if (recipe.peek() !== now) return;
  isLinkable.value = drawn !== null;
  written = encode({
    mode: mode.peek(),
    ...drawn,
    algorithm: chosen.peek(),
    run: runOptions.peek(),
    ...(position.peek() > 0 && { position: position.peek() }),
    kind: kind.peek(),
    mesh: meshOptions.peek(),
    see: [...switched.peek()],
  });
  history.replaceState(history.state, "", `#${written}`);
}

const told = new WeakMap<Recipe, Promise<Address | null>>();

/** Returns how an address tells of a drawing; null if it is too large. */
function tellDrawing(now: Recipe): Promise<Address | null> {
  const known = told.get(now) ?? makeAddress(now);
  told.set(now, known);
  return known;
}

async function makeAddress({ source, edits }: Recipe): Promise<Address | null> {
  if (edits.length === 0) {
    if (source.kind === "preset") {
      const { name, count, seed } = source;
      return { preset: { name, count, seed } };
    }
    const origin = originOf(source);
    if (origin) return { open: origin };
  }
  const packed = await pack(source.kind === "lists" ? folded() : { source, edits });
  return packed === null ? null : { drawing: packed };
}

/** Returns a recipe of the drawing as it is, without how it came about: of lists that says all. */
function folded(): Recipe {
  const { points, segments, holes } = drawing.peek()!;
  return { source: { kind: "lists", points, segments, holes }, edits: [] };
}
