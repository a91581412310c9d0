// Several algorithms beside each other: who, how it ended, and all of them in a table.

import { CheckIcon, CloseIcon } from "../app/icons";
import type { Run } from "../engine/protocol";
import { AlgorithmList } from "../play/AlgorithmChoice";
import { titleOf } from "../play/described";
import "../play/play.css";
import { algorithms } from "../state/play";
import { clock, isFinished, lanes, racers } from "../state/race";
import { count, words } from "../words";
import { Compare } from "./Compare";
import { agreement, FEWEST, MOST, places, testsOf, usual, withRacer } from "./racing";
import { milliseconds } from "./writing";
import "./race.css";

export function RacePanel() {
  return (
    <>
      <Racers />
      <Result />
      <Compare />
    </>
  );
}

function Racers() {
  const say = words.value.race;
  const all = racers.value;
  return (
    <section aria-labelledby="race-heading">
      <h2 id="race-heading">{say.racers}</h2>
      {all.map((name, lane) => (
        <div key={lane} class="racer">
          <select
            class="wide"
            aria-label={say.racer(lane + 1)}
            value={name}
            onChange={(event) => {
              racers.value = withRacer(all, lane, event.currentTarget.value);
            }}
          >
            <AlgorithmList />
          </select>
          {lane === FEWEST && (
            <button type="button" class="tool" aria-label={say.remove} title={say.remove} onClick={remove}>
              <CloseIcon />
            </button>
          )}
        </div>
      ))}
      {all.length < MOST && (
        <button type="button" onClick={add}>
          {say.add}
        </button>
      )}
    </section>
  );
}

const names = (runs: Run[]): string => runs.map((run) => titleOf(run.algorithm, run.title)).join("; ");

function remove(): void {
  racers.value = racers.value.slice(0, FEWEST);
}

function add(): void {
  const all = [...usual, ...algorithms.value.map(({ name }) => name)];
  const free = all.find((name) => !racers.value.includes(name));
  if (free) racers.value = [...racers.value, free];
}

// Room is kept for the table, so that nothing moves when the race ends.
function Result() {
  const say = words.value.race;
  const all = lanes.value;
  const order = places(
    all.map(({ totals }) => totals),
    clock.value,
  );
  const { agree, byDesign } = agreement(
    all.map(({ run }) => run),
    algorithms.value,
  );
  const ranked = all.map((lane, i) => ({ ...lane, place: order[i] })).sort((a, b) => a.place - b.place);
  return (
    <section aria-labelledby="result-heading" class="race-result" data-done={isFinished.value}>
      <h2 id="result-heading">{say.result}</h2>
      <table class="figures">
        <thead>
          <tr>
            <th scope="col">{say.place}</th>
            <th scope="col">{say.algorithm}</th>
            <th scope="col">{say.lane.tests}</th>
            <th scope="col">{say.lane.steps}</th>
            <th scope="col">ms</th>
          </tr>
        </thead>
        <tbody>
          {ranked.map(({ slot, place, run, totals }) => (
            <tr key={slot}>
              <td class="figure">{say.finished(place)}</td>
              <th scope="row">{titleOf(run.algorithm, run.title)}</th>
              <td class="figure">{count(testsOf(run.tally))}</td>
              <td class="figure">{count(run.tally.steps)}</td>
              <td class="figure">{totals.milliseconds === null ? "–" : milliseconds(totals.milliseconds)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {all.length > 0 && (
        <p class={agree ? "same" : "quiet"}>
          {agree && <CheckIcon />} {agree ? say.same : byDesign.length > 0 ? say.byDesign : say.different}
          {!agree && byDesign.length > 0 && ` ${names(byDesign)}.`}
        </p>
      )}
    </section>
  );
}
