// Which algorithm is played, what it does just now, and its pseudocode.

import { algorithm, algorithms, chosen, frame } from "../state/play";
import { words } from "../words";
import { Code } from "./Code";

export function PlayPanel() {
  const say = words.value.play;
  return (
    <section aria-labelledby="play-heading">
      <h2 id="play-heading">{say.heading}</h2>
      <label class="field">
        {say.algorithm}
        <select
          value={chosen.value}
          onChange={(event) => {
            chosen.value = event.currentTarget.value;
          }}
        >
          {algorithms.value.map(({ name, title }) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <p class="quiet">{algorithm.value?.idea}</p>
      <p class="narration" aria-live="polite">
        {frame.value?.narration || say.begin}
      </p>
      <Code />
    </section>
  );
}
