// The guessing game: its rules, how hard it is, and the score.

import { AlgorithmChoice } from "../play/AlgorithmChoice";
import { Code } from "../play/Code";
import { titleOf } from "../play/described";
import { algorithms, chosen, run } from "../state/play";
import { difficulty, score } from "../state/predict";
import { count, words } from "../words";
import "../play/play.css";
import "./predict.css";

/** Algorithms that flip edges, the most instructive first. */
const flipping = ["flip-list", "greedy-flips", "incremental", "cline-renka", "sweep-circle", "edge-flip"];

export function PredictPanel() {
  const say = words.value.predict;
  const isWithout = run.value !== null && run.value.tally.flips === 0;
  return (
    <>
      <section aria-labelledby="predict-heading">
        <h2 id="predict-heading">{say.heading}</h2>
        <p class="quiet">{say.rules}</p>
        <Difficulty />
        <Points />
      </section>
      <AlgorithmChoice />
      {isWithout && <Others />}
      <Code />
    </>
  );
}

function Difficulty() {
  const say = words.value.predict;
  return (
    <fieldset class="difficulty">
      <legend class="quiet">{say.difficulty}</legend>
      {(["three", "all"] as const).map((each) => (
        <label key={each}>
          <input
            type="radio"
            name="difficulty"
            checked={difficulty.value === each}
            onChange={() => {
              difficulty.value = each;
            }}
          />
          {say.difficulties[each]}
        </label>
      ))}
    </fieldset>
  );
}

function Points() {
  const say = words.value.predict;
  const { asked, right, streak, best } = score.value;
  return (
    <dl class="score" aria-label={say.score}>
      <div>
        <dd class="figure">
          {count(right)}/{count(asked)}
        </dd>
        <dt>{say.right}</dt>
      </div>
      <div>
        <dd class="figure">{count(streak)}</dd>
        <dt>{say.streak}</dt>
      </div>
      <div>
        <dd class="figure">{count(best)}</dd>
        <dt>{say.best}</dt>
      </div>
    </dl>
  );
}

function Others() {
  const there = flipping.flatMap((name) => algorithms.value.find((each) => each.name === name) ?? []);
  return (
    <section>
      <p>{words.value.predict.noFlips}</p>
      <div class="others">
        {there.map(({ name, title }) => (
          <button
            key={name}
            type="button"
            onClick={() => {
              chosen.value = name;
            }}
          >
            {titleOf(name, title)}
          </button>
        ))}
      </div>
    </section>
  );
}
