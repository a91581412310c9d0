// Jumping to the next, or the previous, moment of a kind.

import { useSignal } from "@preact/signals";
import { NextIcon, PreviousIcon } from "../app/icons";
import { position, shownRun } from "../state/play";
import { words } from "../words";
import { Button } from "./Button";
import { type Jump, jumps, jumpTo } from "./keys";

export function Jumps() {
  const kind = useSignal<Jump>("flip");
  const say = words.value.play;
  const name = say.kinds[kind.value];
  const key = jumps[kind.value];
  return (
    <fieldset class="jumps" aria-label={say.jump}>
      <Button
        label={say.jumpPrevious(name)}
        keys={kind.value === "change" ? "⇧ ←" : `⇧ ${key}`}
        isOff={position.value === 0}
        act={() => jumpTo("previous", kind.value)}
      >
        <PreviousIcon />
      </Button>
      <select
        aria-label={say.jump}
        value={kind.value}
        onChange={(event) => {
          kind.value = event.currentTarget.value as Jump;
        }}
      >
        {(Object.keys(jumps) as Jump[]).map((each) => (
          <option key={each} value={each}>
            {say.kinds[each]}
          </option>
        ))}
      </select>
      <Button
        label={say.jumpNext(name)}
        keys={kind.value === "change" ? "⇧ →" : key}
        isOff={position.value === (shownRun.value?.length ?? 0)}
        act={() => jumpTo("next", kind.value)}
      >
        <NextIcon />
      </Button>
    </fieldset>
  );
}
