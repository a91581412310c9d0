// How good the mesh is: its figures, a histogram, and what falls short.

import type { MeshData } from "../engine/protocol";
import { mesh } from "../state/mesh";
import { count, words } from "../words";
import { Histogram } from "./Histogram";
import { Unmet } from "./Unmet";
import { degrees, duration, size } from "./writing";

export function Quality() {
  const now = mesh.value;
  if (!now) return <p class="quiet">{words.value.mesh.empty}</p>;
  return (
    <>
      <Histogram />
      {now.kind === "refine" && <Unmet />}
      <Figures of={now} />
    </>
  );
}

function Figures({ of }: { of: MeshData }) {
  const say = words.value.mesh.figures;
  return (
    <table class="mesh-figures">
      <caption>{say.heading}</caption>
      <tbody>
        {rowsOf(of).map(([name, value, isPart]) => (
          <tr key={name} class={isPart ? "part" : ""}>
            <th scope="row">{name}</th>
            <td class="figure">{value}</td>
          </tr>
        ))}
        <tr>
          <th scope="row">{say.hash}</th>
          <td>
            <code title={of.hash}>{of.hash.slice(0, 12)}…</code>
          </td>
        </tr>
      </tbody>
    </table>
  );
}

/** Name, value, and whether it is a part of the row above. */
type Row = [name: string, value: string, isPart?: boolean];

function rowsOf({ quality, milliseconds, kind }: MeshData): Row[] {
  const { figures } = words.value.mesh;
  const span = (low: number | null, high: number | null, write: (value: number) => string): string =>
    low === null || high === null ? "–" : figures.span(write(low), write(high));
  const rows: Row[] = [
    [figures.triangles, count(quality.triangles)],
    [figures.vertices, count(quality.vertices)],
  ];
  if (kind === "refine") rows.push([figures.steiner, count(quality.steiner), true]);
  rows.push([figures.edges, count(quality.edges)]);
  if (kind !== "triangulate") rows.push([figures.constrained, count(quality.constrainedEdges), true]);
  if (quality.crossingsSplit > 0) rows.push([figures.crossings, count(quality.crossingsSplit)]);
  if (quality.duplicates > 0) rows.push([figures.duplicates, count(quality.duplicates)]);
  rows.push([figures.angles, span(quality.minAngle, quality.maxAngle, degrees)]);
  if (quality.meanMinAngle !== null) rows.push([figures.meanMinAngle, degrees(quality.meanMinAngle)]);
  rows.push(
    [figures.lengths, span(quality.shortestEdge, quality.longestEdge, size)],
    [figures.areas, span(quality.smallestArea, quality.largestArea, size)],
    [figures.area, size(quality.area)],
    [figures.time, duration(milliseconds)],
  );
  return rows;
}
