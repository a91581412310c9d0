// The steps of a run, read backwards: what a step is part of lies before it.

import type { Player } from "../wasm/delone.js";
import { type Arrivals, type Happening, NONE, type Queue, queues } from "./protocol";

/** How far anyone looks back, or ahead: steps. */
const FAR = 4096;

/** How many steps of a turn are told: what is drawn of more is a carpet. */
const LONG = 600;

/** How many steps are remembered, some 200 bytes each, before all are forgotten. */
const ROOM = 30_000;

/** Things that wait beyond which nobody can read in which order. */
const MANY = 3000;

/** With these something new begins: what came before is another story. */
const beginnings = new Set([
  "point-considered",
  "segment-considered",
  "triangle-considered",
  "set-divided",
  "encroached",
  "circumcenter-proposed",
  "cluster-split",
  "stage-ended",
  "taken-back",
]);

/** What a run has done up to a position. It moves the player. */
export class Past {
  private readonly known = new Map<number, Happening>();

  constructor(private readonly player: Player) {}

  /** Returns what has happened since the turn began that is under way at a position, oldest first. */
  turn(position: number): Happening[] {
    const found: Happening[] = [];
    // The run may be another one by now, and shorter.
    for (let at = Math.min(position, this.player.length); at > 0 && found.length < LONG; at--) {
      const happening = this.at(at);
      // The end of a stage ends what came before it.
      if (happening.kind === "stage-ended" && at < position) break;
      found.push(happening);
      if (beginnings.has(happening.kind)) break;
    }
    return found.reverse();
  }

  /** Tells when what waits at a position has come, and what goes first. */
  arrivals(position: number): Arrivals {
    this.player.seek(position);
    const ranks: Arrivals["ranks"] = {};
    const open = new Map<string, number>();
    const rows = new Map<Queue, string[]>();
    for (const queue of queues) {
      const items = this.player.waiting(queue);
      const keys: string[] = [];
      for (let i = 0; i < items.length; i += 3) keys.push(keyOf(queue, items.subarray(i, i + 3)));
      if (keys.length > 0) rows.set(queue, keys);
      for (const key of keys) open.set(key, (open.get(key) ?? 0) + 1);
    }
    const came = this.pushes(position, open.size > MANY ? new Map() : open);
    for (const [queue, keys] of rows) ranks[queue] = rank(keys.map((key) => came.get(key)?.pop() ?? 0));
    return { ranks, next: rows.size > 0 ? this.next(position) : null };
  }

  /** Finds at which positions things have come that are waited for; `open` says how many of each. */
  private pushes(position: number, open: Map<string, number>): Map<string, number[]> {
    const came = new Map<string, number[]>();
    for (
      let at = Math.min(position, this.player.length);
      at > 0 && at > position - FAR && open.size > 0;
      at--
    ) {
      const { kind, event } = this.at(at);
      if (kind !== "pushed") continue;
      const key = keyOf(event.queue as Queue, rowOf(event.item));
      const left = open.get(key);
      if (left === undefined) continue;
      if (left > 1) open.set(key, left - 1);
      else open.delete(key);
      came.set(key, [...(came.get(key) ?? []), at]);
    }
    return came;
  }

  private next(position: number): Arrivals["next"] {
    const found = this.player.next("popped", position);
    if (found === undefined || found > position + FAR) return null;
    // What comes only then does not wait yet.
    const pushed = this.player.next("pushed", position) ?? Number.POSITIVE_INFINITY;
    if (pushed < found) return null;
    const { event } = this.at(found);
    return { queue: event.queue as Queue, row: rowOf(event.item) };
  }

  private at(position: number): Happening {
    const known = this.known.get(position);
    if (known) return known;
    this.player.seek(position);
    const { kind, event } = JSON.parse(this.player.step());
    const happening = { position, kind, event: event[kind] ?? {} };
    if (this.known.size >= ROOM) this.known.clear();
    this.known.set(position, happening);
    return happening;
  }
}

/** Writes an item of an event as a row of what waits. */
export function rowOf(item: unknown): [number, number, number] {
  const [vertices] = Object.values(item as Record<string, number | number[]>);
  const [a, b = NONE, c = NONE] = [vertices].flat();
  return [a, b, c];
}

/** Numbers positions by their order from 1 on; 0 stays 0. */
export function rank(positions: number[]): number[] {
  const sorted = positions.filter((at) => at > 0).toSorted((a, b) => a - b);
  const places = new Map(sorted.map((at, i) => [at, i + 1]));
  return positions.map((at) => places.get(at) ?? 0);
}

const keyOf = (queue: Queue, row: ArrayLike<number>): string => `${queue} ${Array.from(row).join(" ")}`;
