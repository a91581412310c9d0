// What has just been done, in a sentence. It is read out while one can listen: not while the run plays fast.

import { stopped } from "../state/breakpoints";
import { drawing } from "../state/drawing";
import { jobs } from "../state/job";
import { frame, heading, isPlaying, position, shownRun, speed } from "../state/play";
import { words } from "../words";
import { sayCondition } from "./conditions";
import { sayKind } from "./described";

/** Steps a second beyond which nobody listens. */
const LISTENING = 1;

/** What is said where the run says nothing: before its first step, or because there is none. */
function silence(): string {
  const say = words.value.play;
  if (shownRun.value?.length === 0) return say.nothing;
  return shownRun.value || jobs.value.length > 0 || !drawing.value ? say.begin : say.noRun;
}

export function Narration() {
  const say = words.value.play;
  const shown = frame.value;
  const isFast = isPlaying.value && speed.value > LISTENING;
  const here = stopped.value?.position === position.value ? stopped.value : null;
  const isEnd = shown !== null && shown.position > 0 && shown.position === shownRun.value?.length;
  return (
    <section class="narration" aria-live={isFast ? "off" : "polite"} data-way={heading.value}>
      <p>{shown?.narration || silence()}</p>
      <p class="quiet narration-note">
        {here && <strong>{say.breakpoints.stopped(sayCondition(here.breakpoint.condition))}</strong>}
        {!here && isEnd && say.end}
        {!here && !isEnd && shown?.step && <Kind of={shown.step.kind} />}
      </p>
    </section>
  );
}

/** Names of the library are set like code. */
function Kind({ of }: { of: string }) {
  const said = sayKind(of);
  return said === of ? <code>{of}</code> : <span>{said}</span>;
}
