// What is below the stage: the timeline, and the buttons. On phones one row of buttons, the rest folded away.

import { useSignal } from "@preact/signals";
import {
  BackwardsIcon,
  FirstIcon,
  LastIcon,
  MoreIcon,
  PauseIcon,
  PlayIcon,
  StepBackIcon,
  StepIcon,
} from "../app/icons";
import { heading, isPlaying, position, shownRun } from "../state/play";
import { count, words } from "../words";
import { Button } from "./Button";
import "./clock";
import { Jumps } from "./Jumps";
import { go, goToEnd, step, togglePlaying } from "./keys";
import { Legend } from "./Legend";
import { Speed } from "./Speed";
import { Timeline } from "./Timeline";
import "./transport.css";

export function Transport() {
  const say = words.value.play;
  const length = shownRun.value?.length ?? 0;
  const isOpen = useSignal(false);
  const written = say.of(count(length), count(length)).length;
  return (
    <section class="transport" aria-label={say.transport}>
      <Timeline />
      <div class="transport-row">
        <Buttons length={length} />
        <span class="figure transport-at" style={{ minWidth: `${written}ch` }}>
          {say.of(count(position.value), count(length))}
        </span>
        <Legend />
        <button
          type="button"
          class="transport-fold"
          aria-label={say.more}
          aria-expanded={isOpen.value}
          onClick={() => {
            isOpen.value = !isOpen.value;
          }}
        >
          <MoreIcon />
        </button>
        <div class="transport-more" data-open={isOpen.value}>
          <Jumps />
          <Speed />
        </div>
      </div>
    </section>
  );
}

function Buttons({ length }: { length: number }) {
  const say = words.value.play;
  const at = position.value;
  const isOn = isPlaying.value;
  return (
    <div class="transport-main">
      <Button label={say.first} keys="Home" isOff={at === 0} act={() => go(0)}>
        <FirstIcon />
      </Button>
      <Button
        label={say.playBackwards}
        keys={`⇧ ${words.value.app.space}`}
        isOff={length === 0}
        act={() => togglePlaying("previous")}
      >
        <BackwardsIcon />
      </Button>
      <Button label={say.previous} keys="←" isOff={at === 0} act={() => step(-1)}>
        <StepBackIcon />
      </Button>
      <Button
        label={isOn ? say.pause : say.play}
        keys={words.value.app.space}
        isOff={length === 0}
        act={() => togglePlaying(isOn ? heading.value : "next")}
        isMain
      >
        {isOn ? <PauseIcon /> : <PlayIcon />}
      </Button>
      <Button label={say.next} keys="→" isOff={at === length} act={() => step(1)}>
        <StepIcon />
      </Button>
      <Button label={say.last} keys="End" isOff={at === length} act={goToEnd}>
        <LastIcon />
      </Button>
    </div>
  );
}
