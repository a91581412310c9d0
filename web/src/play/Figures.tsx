// What a run has done: up to here, and in total; and which triangulation came of it.

import { effect, signal } from "@preact/signals";
import { CheckIcon } from "../app/icons";
import type { Tally } from "../engine/protocol";
import { drawing } from "../state/drawing";
import { tell } from "../state/notices";
import { algorithm, askRun, frame, run, shownRun } from "../state/play";
import { count, words } from "../words";

const rows = [
  "steps",
  "orientationTests",
  "circleTests",
  "ties",
  "walkSteps",
  "flips",
  "edgesCreated",
  "edgesDeleted",
  "trianglesCreated",
  "trianglesDeleted",
  "verticesCreated",
  "pushed",
] as const satisfies (keyof Tally)[];

/** Points beyond which the library is not asked for its triangulation as well. */
const MOST = 20_000;

/** The hash of the library's triangulation of the drawing's points; null: not known. */
const libraryHash = signal<string | null>(null);

effect(() => {
  const [of, drawn] = [run.value, drawing.peek()];
  if (of) libraryHash.value = null;
  if (!of || !drawn || !algorithm.peek()?.delaunay || drawn.about.points > MOST) return;
  askRun(({ players }) => players.libraryHash()).then((hash) => {
    if (run.peek() === of) libraryHash.value = hash;
  }, tell);
});

export function Figures() {
  const say = words.value.play.figures;
  const total = shownRun.value?.tally;
  if (!total) return null;
  const here = frame.value?.tally;
  return (
    <details class="fold">
      <summary>{say.heading}</summary>
      <table class="figures">
        <thead>
          <tr>
            <td />
            <th scope="col">{say.here}</th>
            <th scope="col">{say.total}</th>
          </tr>
        </thead>
        <tbody>
          {rows
            .filter((row) => total[row] > 0)
            .map((row) => (
              <tr key={row}>
                <th scope="row">{say.rows[row]}</th>
                <td class="figure">{here ? count(here[row]) : "–"}</td>
                <td class="figure">{count(total[row])}</td>
              </tr>
            ))}
        </tbody>
      </table>
      <Result />
    </details>
  );
}

function Result() {
  const say = words.value.play.figures;
  const hash = shownRun.value?.hash ?? "";
  return (
    <p class="result" title={say.hashHint}>
      {say.hash} <code>{hash}</code>
      {libraryHash.value === hash && (
        <span class="same">
          <CheckIcon /> {say.same}
        </span>
      )}
    </p>
  );
}
