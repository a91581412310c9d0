// Points of the plane raised to the paraboloid z = x² + y², and turned before the eye. Orthographic; rounded, for
// drawing.

import type { Coordinates, Indices } from "../engine/protocol";
import type { Box } from "../stage/camera";

/** From where the scene is looked at, in radians, and how far it is raised. */
export interface Posture {
  /** About the axis of the paraboloid. */
  azimuth: number;
  /** Above the plane: a right angle looks straight down. */
  tilt: number;
  /** From 0, flat, to 1. */
  lift: number;
}

/** From straight above, flat: what the stage shows. */
export const above: Posture = { azimuth: 0, tilt: Math.PI / 2, lift: 0 };

/** From the side. */
export const aside: Posture = { azimuth: -0.45, tilt: 0.42, lift: 1 };

/** Height of the paraboloid at distance 1, where half of the longer side of the box is 1. */
const STEEP = 0.62;
/** How far it is let down when it is raised, so that it stays in the middle. */
const DOWN = 0.55;
/** How far the floor lies below the lowest place. */
const FLOOR = 0.14;

/** The map from the plane to space: coordinates relative to the box, and heights. */
export class Lift {
  private readonly middle: [number, number];
  private readonly half: number;

  constructor(
    { low, high }: Box,
    readonly posture: Posture,
  ) {
    const halves = [high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2];
    this.middle = [low[0] + halves[0], low[1] + halves[1]];
    this.half = Math.max(...halves) || 1;
  }

  /** Returns x and y from -1 to 1 in the box. */
  relative(x: number, y: number): [number, number] {
    return [(x - this.middle[0]) / this.half, (y - this.middle[1]) / this.half];
  }

  /** Returns the height over a relative place: of the paraboloid. */
  height(u: number, v: number): number {
    return this.posture.lift * (STEEP * (u * u + v * v) - DOWN);
  }

  /**
   * Returns how far the paraboloid at a place lies above the plane of a circle: its power, raised. The place is
   * relative to the center. Negative inside.
   */
  above(u: number, v: number, radius: number): number {
    return this.posture.lift * STEEP * (u * u + v * v - radius * radius);
  }

  /** Returns the height of the floor. */
  get floor(): number {
    return -this.posture.lift * (DOWN + FLOOR);
  }

  /** Returns where a place in space is seen: to the right, upwards, and towards the eye. */
  see(u: number, v: number, w: number): [number, number, number] {
    const { azimuth, tilt } = this.posture;
    const [cos, sin] = [Math.cos(azimuth), Math.sin(azimuth)];
    const right = u * cos - v * sin;
    const away = u * sin + v * cos;
    return [right, away * Math.sin(tilt) + w * Math.cos(tilt), w * Math.sin(tilt) - away * Math.cos(tilt)];
  }

  /** Sees points on the paraboloid, or on the floor: three numbers each. */
  seeAll(points: Coordinates, isFloor = false): Float64Array {
    const seen = new Float64Array((points.length / 2) * 3);
    for (let i = 0; 2 * i < points.length; i++) {
      const [u, v] = this.relative(points[2 * i], points[2 * i + 1]);
      seen.set(this.see(u, v, isFloor ? this.floor : this.height(u, v)), 3 * i);
    }
    return seen;
  }
}

/** Returns triangles in the order in which a painter lays them on: the farthest first, by their middles. */
export function paintersOrder(triangles: Indices, seen: Float64Array): Uint32Array {
  const count = triangles.length / 3;
  const depth = new Float64Array(count);
  for (let t = 0; t < count; t++) {
    for (let k = 0; k < 3; k++) depth[t] += seen[3 * triangles[3 * t + k] + 2];
  }
  return Uint32Array.from({ length: count }, (_, t) => t).sort((s, t) => depth[s] - depth[t] || s - t);
}

/**
 * Returns how light falls on a seen triangle: from 0 to 1, and negative where its upper side is turned away from the
 * eye.
 */
export function lightOn(seen: Float64Array, a: number, b: number, c: number): number {
  const [i, j, k] = [3 * a, 3 * b, 3 * c];
  const [ux, uy, uz] = [seen[j] - seen[i], seen[j + 1] - seen[i + 1], seen[j + 2] - seen[i + 2]];
  const [vx, vy, vz] = [seen[k] - seen[i], seen[k + 1] - seen[i + 1], seen[k + 2] - seen[i + 2]];
  const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(nx, ny, nz);
  if (!(length > 0)) return 0;
  // From the left, above and behind the eye.
  const facing = Math.sign(nz) || 1;
  const light = (facing * (-0.35 * nx + 0.5 * ny + 0.79 * nz)) / length;
  return facing * Math.max(0.02, Math.min(1, light));
}

/** Returns the posture between two, at a share of the way that is made softly. */
export function between(from: Posture, to: Posture, share: number): Posture {
  const soft = share * share * (3 - 2 * share);
  const mix = (a: number, b: number) => (1 - soft) * a + soft * b;
  return {
    azimuth: mix(from.azimuth, to.azimuth),
    tilt: mix(from.tilt, to.tilt),
    lift: mix(from.lift, to.lift),
  };
}

/** Turns a posture; it never looks from below the floor nor over its back. */
export function turned(posture: Posture, aboutAxis: number, upwards: number): Posture {
  const tilt = Math.max(-0.35, Math.min(Math.PI / 2, posture.tilt + upwards));
  return { ...posture, azimuth: posture.azimuth + aboutAxis, tilt };
}
