// Runs and their scenes, in the worker. Several may be there at once, each in a slot.

import { transfer } from "comlink";
import { Player } from "../wasm/delone.js";
import { drawing } from "./drawings";
import { takeFiles } from "./files";
import {
  type Algorithm,
  type Direction,
  type Frame,
  type Language,
  type NamedBytes,
  queues,
  type Run,
  type RunOptions,
  type RunSaveOptions,
} from "./protocol";

const slots = new Map<number, Player>();

export const players = {
  algorithms: (): Algorithm[] => JSON.parse(Player.algorithms()),

  /** Runs an algorithm on the drawing. */
  run: (slot: number, algorithm: string, options: RunOptions): Run =>
    keep(slot, Player.run(algorithm, drawing(), JSON.stringify(options))),

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

  /** Writes the run; the extension of the name tells the format. */
  save: (slot: number, name: string, options: RunSaveOptions): NamedBytes[] =>
    takeFiles(at(slot).save(name, JSON.stringify(options))),
};

/** Returns the run in a slot. */
export function at(slot: number): Player {
  const player = slots.get(slot);
  if (!player) throw new Error("bug: no run is here");
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
  };
  const { points, edges, locked, triangles } = frame;
  return transfer(frame, [points.buffer, edges.buffer, locked.buffer, triangles.buffer]);
}
