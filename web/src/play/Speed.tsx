// How fast a run plays.

import { speed } from "../state/play";
import { number, words } from "../words";
import { FASTEST, placeOf, speedAt } from "./pace";

/** Keys that move a slider, and would step the run otherwise. */
const own = new Set(["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp", "PageDown"]);

export function Speed() {
  const say = words.value.play;
  const told = speed.value === Number.POSITIVE_INFINITY ? say.fastest : say.perSecond(number(speed.value));
  return (
    <label class="speed">
      <span class="quiet">{say.speed}</span>
      <input
        type="range"
        min={0}
        max={FASTEST}
        value={placeOf(speed.value)}
        aria-valuetext={told}
        onKeyDown={(event) => own.has(event.key) && event.stopPropagation()}
        onInput={(event) => {
          speed.value = speedAt(event.currentTarget.valueAsNumber);
        }}
      />
      <span class="figure quiet speed-told">{told}</span>
    </label>
  );
}
