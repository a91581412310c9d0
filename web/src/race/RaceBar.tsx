// What is below the stages of a race: its buttons, and one slider for all.

import { PauseIcon, PlayIcon, RestartIcon } from "../app/icons";
import { bind } from "../app/shortcuts";
import { Button } from "../play/Button";
import "../play/transport.css";
import { type Clock, clocks } from "../engine/protocol";
import { amount, clock, duration, full, goTo, isRacing, lanes, setClock, toggleRace } from "../state/race";
import { count, number, words } from "../words";
import { milliseconds } from "./writing";

/** The slider has so many places. */
const PLACES = 1000;

/** Seconds that a race may take. */
const durations = [3, 6, 12, 24, 60];

function restart(): void {
  isRacing.value = false;
  goTo(0);
}

/** Part of the race that an arrow key goes. */
const nudge = (by: number) => {
  isRacing.value = false;
  goTo(amount.value + (by * full.value) / 100);
};

bind("race", " ", "startPause", toggleRace);
bind("race", "Home", "first", restart);
bind("race", "End", "last", () => goTo(full.value));
bind("race", "ArrowRight", "forward", () => nudge(1));
bind("race", "ArrowLeft", "backward", () => nudge(-1));

export function RaceBar() {
  const say = words.value.race;
  const isOff = lanes.value.length === 0;
  const write = clock.value === "milliseconds" ? milliseconds : count;
  const told = say.amounts[clock.value](write(whole(amount.value)), write(whole(full.value)));
  return (
    <section class="transport" aria-label={say.bar}>
      <input
        type="range"
        class="race-slider"
        aria-label={say.position}
        aria-valuetext={told}
        min={0}
        max={PLACES}
        disabled={isOff}
        value={full.value > 0 ? (amount.value / full.value) * PLACES : 0}
        onInput={(event) => {
          isRacing.value = false;
          goTo((event.currentTarget.valueAsNumber / PLACES) * full.value);
        }}
      />
      <div class="transport-row">
        <div class="transport-main race-main">
          <Button label={say.restart} keys="Home" isOff={isOff || amount.value === 0} act={restart}>
            <RestartIcon />
          </Button>
          <Button
            label={isRacing.value ? say.pause : say.start}
            keys={words.value.app.space}
            isOff={isOff}
            act={toggleRace}
            isMain
          >
            {isRacing.value ? <PauseIcon /> : <PlayIcon />}
          </Button>
        </div>
        <span class="figure race-told">{told}</span>
        <Settings />
      </div>
    </section>
  );
}

// Tests and steps come whole.
const whole = (used: number) => (clock.value === "milliseconds" ? used : Math.floor(used));

function Settings() {
  const say = words.value.race;
  return (
    <div class="transport-more" data-open="true">
      <label title={say.clockHints[clock.value]}>
        <span class="quiet">{say.clock}</span>
        <select value={clock.value} onChange={(event) => setClock(event.currentTarget.value as Clock)}>
          {clocks.map((each) => (
            <option key={each} value={each}>
              {say.clocks[each]}
            </option>
          ))}
        </select>
      </label>
      <label>
        <span class="quiet">{say.duration}</span>
        <select
          value={duration.value}
          onChange={(event) => {
            duration.value = Number(event.currentTarget.value);
          }}
        >
          {durations.map((each) => (
            <option key={each} value={each}>
              {say.seconds(number(each))}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}
