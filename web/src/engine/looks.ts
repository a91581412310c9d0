// What can be seen of a run beside its scene, in the worker: asked for only while somebody looks.

import { transfer } from "comlink";
import type { Looker, Player } from "../wasm/delone.js";
import { Past } from "./past";
import { at } from "./players";
import type { Arrivals, CircleSide, Happening, Indices, Judged, JudgedEdges, Nearest } from "./protocol";

const pasts = new WeakMap<Player, Past>();

/** The looker of the scene that was looked at last, and which one that was. */
let last: { of: Player; position: number; looker: Looker } | undefined;

export const looks = {
  /** What has happened in the turn that is under way at a position, oldest first. */
  turn: (slot: number, position: number): Happening[] => pastOf(slot).turn(position),

  /** In which order things wait. */
  arrivals: (slot: number, position: number): Arrivals => pastOf(slot).arrivals(position),

  /** Judges the edges of the scene, exactly. */
  edges(slot: number, position: number): JudgedEdges {
    const player = stand(slot, position);
    const [cocircular, illegal] = [player.cocircular(), player.illegal()];
    return transfer({ cocircular, illegal }, [cocircular.buffer, illegal.buffer]);
  },

  /** Judges whether a vertex is in the circle through three others, exactly; null: there is no circle. */
  judged(
    slot: number,
    position: number,
    [a, b, c, d]: readonly [number, number, number, number],
  ): Judged | null {
    const player = stand(slot, position);
    const side = JSON.parse(player.side(a, b, c, d));
    return side && { ...side, circle: JSON.parse(player.circle(a, b, c)) };
  },

  /** On which side of the circle through three vertices others lie, exactly; nowhere if the three are on one line. */
  sides(
    slot: number,
    position: number,
    [a, b, c]: readonly number[],
    vertices: readonly number[],
  ): (CircleSide | null)[] {
    const player = stand(slot, position);
    return vertices.map((v) => JSON.parse(player.side(a, b, c, v)));
  },

  /** For each vertex the triangle for which it counts as a datum, or NONE thrice. */
  holders(slot: number, position: number): Indices {
    const holders = stand(slot, position).holders();
    return transfer(holders, [holders.buffer]);
  },

  /** Finds the vertex nearest to a place; null if there is none. */
  nearest: (slot: number, position: number, x: number, y: number): Nearest | null =>
    JSON.parse(lookerOf(slot, position).nearest(x, y)),

  /** The borders of the Voronoi cells of all vertices, clipped to a box around them: x, y, x, y for each. */
  cells(slot: number, position: number): Float64Array {
    const cells = lookerOf(slot, position).cells();
    return transfer(cells, [cells.buffer]);
  },
};

function stand(slot: number, position: number): Player {
  const player = at(slot);
  player.seek(position);
  return player;
}

function pastOf(slot: number): Past {
  const player = at(slot);
  const past = pasts.get(player) ?? new Past(player);
  pasts.set(player, past);
  return past;
}

function lookerOf(slot: number, position: number): Looker {
  const player = stand(slot, position);
  if (last?.of === player && last.position === position) return last.looker;
  last?.looker.free();
  last = undefined;
  last = { of: player, position, looker: player.looker() };
  return last.looker;
}
