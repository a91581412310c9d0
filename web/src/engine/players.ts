// Runs and their scenes, in the worker. Several may be there at once, each in a slot.

import { transfer } from "comlink";
import { Mesh, Player } from "../wasm/delone.js";
import { drawing } from "./drawings";
import { takeFiles } from "./files";
import { GONE } from "./gone";
import { countMoments } from "./moments";
import {
  type Algorithm,
  type Clock,
  type Condition,
  type CurveName,
  type Direction,
  type Frame,
  type Language,
  type Measured,
  type NamedBytes,
  type Progress,
  queues,
  type Run,
  type RunOptions,
  type RunSaveOptions,
  type Stop,
  type Told,
} from "./protocol";

const slots = new Map<number, Player>();

export const players = {
  algorithms: (): Algorithm[] => JSON.parse(Player.algorithms()),

  /** Runs an algorithm on the drawing. */
  run: (slot: number, algorithm: string, options: RunOptions, progress?: Progress): Run =>
    keep(slot, Player.run(algorithm, drawing(), JSON.stringify(options), progress)),

  /** Runs an algorithm for its figures alone. */
  measure(algorithm: string, options: RunOptions, progress?: Progress): Measured {
    const player = Player.run(algorithm, drawing(), JSON.stringify(options), progress);
    try {
      player.seek(player.length);
      const milliseconds = player.total("milliseconds") ?? 0;
      return { algorithm, tally: JSON.parse(player.tally()), hash: player.hash(), milliseconds };
    } finally {
      player.free();
    }
  },

  /** Names the set of triangles that the library makes of the same points. */
  libraryHash(): string {
    const mesh = Mesh.triangulate(drawing());
    const hash = mesh.hash();
    mesh.free();
    return hash;
  },

  /** Opens the log of a run. */
  open: (slot: number, file: NamedBytes): Run => keep(slot, Player.fromLog(file.name, file.bytes)),

  /** Gives a slot back. */
  close(slot: number): void {
    slots.get(slot)?.free();
    slots.delete(slot);
  },

  /** Goes to a position and shows the scene there. */
  frame(slot: number, position: number, language: Language): Frame {
    const player = at(slot);
    player.seek(position);
    return look(player, language);
  },

  /** Finds the nearest position, before or behind one, at which a step of this kind has just been taken. */
  find: (slot: number, direction: Direction, kind: string, from: number): number | undefined =>
    at(slot)[direction](kind, from),

  /** Finds the nearest position, before or behind one, that meets a condition; the first of them if several do. */
  stop(slot: number, conditions: Condition[], from: number, backwards: boolean): Stop | undefined {
    let nearest: Stop | undefined;
    conditions.forEach((condition, which) => {
      const position = search(at(slot), condition, from, backwards);
      if (position === undefined) return;
      const isNearer = !nearest || (backwards ? position > nearest.position : position < nearest.position);
      if (isNearer) nearest = { position, which };
    });
    return nearest;
  },

  /** Lists the first positions that meet a condition, `most` of them for each. */
  stops(slot: number, conditions: Condition[], most: number): number[] {
    const found = conditions.flatMap((condition) => {
      const positions: number[] = [];
      let position = search(at(slot), condition, 0, false);
      while (position !== undefined && positions.length < most) {
        positions.push(position);
        position = search(at(slot), condition, position, false);
      }
      return positions;
    });
    return [...new Set(found)].sort((a, b) => a - b);
  },

  /** Counts steps of a kind in equal stretches of the run. */
  moments(slot: number, kind: string, stretches: number): Uint32Array {
    const player = at(slot);
    return countMoments((from) => player.next(kind, from), player.length, stretches);
  },

  /** Tells how a number changes: a position and the value from there on, and so forth; a few hundred pairs. */
  curve: (slot: number, name: CurveName, limit: number): Float64Array => at(slot).curve(name, limit),

  /** Counts triangles at a position by their smallest angle, in degrees. */
  angles(slot: number, position: number): Uint32Array {
    at(slot).seek(position);
    return at(slot).angles();
  },

  /** Tells of the step before a position, and nothing else. */
  tell(slot: number, position: number, language: Language): Told {
    const player = at(slot);
    player.seek(position);
    return { step: JSON.parse(player.step()), narration: player.narration(language) };
  },

  /** Tells how much of a unit a run has used up to its end; null if nobody knows. */
  total: (slot: number, clock: Clock): number | null => at(slot).total(clock) ?? null,

  /** Shows the last scene before a run uses more of a unit than this. */
  frameAt: (slot: number, clock: Clock, amount: number, language: Language): Frame =>
    players.frame(slot, at(slot).positionAt(clock, amount), language),

  /** Writes the run; the extension of the name tells the format. */
  save: (slot: number, name: string, options: RunSaveOptions): NamedBytes[] =>
    takeFiles(at(slot).save(name, JSON.stringify(options))),
};

/** Returns the run in a slot. */
export function at(slot: number): Player {
  const player = slots.get(slot);
  if (!player) throw new Error(GONE);
  return player;
}

function keep(slot: number, player: Player): Run {
  players.close(slot);
  slots.set(slot, player);
  player.seek(player.length);
  const run: Run = {
    algorithm: player.algorithm,
    title: player.title,
    code: JSON.parse(player.code()),
    length: player.length,
    tally: JSON.parse(player.tally()),
    hash: player.hash(),
  };
  player.seek(0);
  return run;
}

// A line is met where it begins to run, and not again at each of its steps.
function search(player: Player, condition: Condition, from: number, backwards: boolean): number | undefined {
  const wanted = JSON.stringify([condition]);
  let position = player.search(wanted, from, backwards);
  while ("line" in condition && position !== undefined && player.next("line", position - 1) !== position)
    position = player.search(wanted, position, backwards);
  return position;
}

function look(player: Player, language: Language): Frame {
  const waiting: Frame["waiting"] = {};
  for (const queue of queues) {
    const items = player.waiting(queue);
    if (items.length > 0) waiting[queue] = items;
  }
  const frame: Frame = {
    position: player.position,
    points: player.points(),
    edges: player.edges(),
    locked: player.locked(),
    triangles: player.triangles(),
    front: player.front(),
    sweep: JSON.parse(player.sweep()),
    waiting,
    clusters: player.clusters(),
    step: JSON.parse(player.step()),
    narration: player.narration(language),
    tally: JSON.parse(player.tallyAt(player.position)),
  };
  const { points, edges, locked, triangles } = frame;
  return transfer(frame, [points.buffer, edges.buffer, locked.buffer, triangles.buffer]);
}
