// A scene as it lies on the graphics processor. A list is uploaded when it is another array than before, and only then.

import { type Anchor, anchorOf, place } from "../anchor";
import { boxOf } from "../camera";
import { spacingOf } from "../density";
import { type Sorted, sortEdges } from "../lengths";
import type { StageScene } from "../scene";
import type { Gl } from "./program";
import { Table } from "./table";

/** The ends of sorted edges in a table, and what their lengths are. */
export interface Edges extends Pick<Sorted, "until" | "mean"> {
  table: Table;
}

export class Stock {
  anchor: Anchor = { x: 0, y: 0, unit: 1 };
  /** How far points are from each other, in units of the anchor. */
  spacing = 0;
  scene: StageScene | null = null;
  places: Table | null = null;
  corners: Table | null = null;
  values: Table | null = null;
  ordinary: Edges | null = null;
  locked: Edges | null = null;

  /** `count` is called for each upload. */
  constructor(
    private readonly gl: Gl,
    private readonly count: () => void,
  ) {}

  /** Uploads what is new in a scene. Throws a `RangeError` if it is more than the device can hold. */
  take(scene: StageScene): void {
    const before = this.scene;
    if (scene === before) return;
    // Whatever fails below, the next scene is taken from the start.
    this.scene = null;
    const isMoved = scene.points !== before?.points || scene.dotsFrom !== before.dotsFrom;
    if (isMoved) this.takePoints(scene);
    if (scene.triangles !== before?.triangles) {
      this.corners = this.replace(this.corners, scene.triangles, 1);
    }
    if (scene.values !== before?.values) this.values = this.replace(this.values, scene.values, 1);
    if (isMoved || scene.edges !== before?.edges || scene.locked !== before?.locked) this.takeEdges(scene);
    this.scene = scene;
  }

  /** Gives everything back. */
  clear(): void {
    for (const table of [this.places, this.corners, this.values]) table?.delete();
    for (const edges of [this.ordinary, this.locked]) edges?.table.delete();
    this.places = this.corners = this.values = this.ordinary = this.locked = this.scene = null;
  }

  private takePoints(scene: StageScene): void {
    this.anchor = anchorOf(boxOf(scene.points));
    this.spacing = spacingOf(scene) / this.anchor.unit;
    this.places = this.replace(this.places, place(scene.points, this.anchor), 2);
  }

  private takeEdges(scene: StageScene): void {
    const { ordinary, locked } = sortEdges(scene, this.anchor);
    this.ordinary = this.replaceEdges(this.ordinary, ordinary);
    this.locked = this.replaceEdges(this.locked, locked);
  }

  private replaceEdges(before: Edges | null, sorted: Sorted): Edges | null {
    const table = this.replace(before?.table ?? null, sorted.edges, 2);
    return table && { until: sorted.until, mean: sorted.mean, table };
  }

  private replace(
    before: Table | null,
    list: Float32Array | Uint32Array | null,
    perCell: 1 | 2,
  ): Table | null {
    before?.delete();
    if (!list || list.length === 0) return null;
    this.count();
    return new Table(this.gl, list, perCell);
  }
}
