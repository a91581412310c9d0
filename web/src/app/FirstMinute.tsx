// The card for newcomers: what to try first. In little room only the next of these.

import { words } from "../words";
import { doFirst, type FirstStep, firstStates, firstSteps, isFirstMinuteShown } from "./firstMinute";
import { CloseIcon, DoneStepIcon, OpenStepIcon } from "./icons";
import "./newcomer.css";

interface Props {
  isShort?: boolean;
}

export function FirstMinute({ isShort = false }: Props) {
  if (isFirstMinuteShown.value !== "shown") return null;
  const say = words.value.help.first;
  const next = firstSteps.find((step) => firstStates[step].value === "open");
  const shown = isShort ? firstSteps.filter((step) => step === next) : firstSteps;
  return (
    <section class="newcomer" data-short={isShort} aria-labelledby="first-heading">
      <h2 id="first-heading">{next ? say.heading : say.done}</h2>
      <button
        type="button"
        class="icon-button close"
        aria-label={say.dismiss}
        title={say.dismiss}
        onClick={() => {
          isFirstMinuteShown.value = "dismissed";
        }}
      >
        <CloseIcon />
      </button>
      <ol>
        {shown.map((step) => (
          <Step key={step} of={step} isNext={step === next} />
        ))}
      </ol>
    </section>
  );
}

function Step({ of, isNext }: { of: FirstStep; isNext: boolean }) {
  const say = words.value.help.first;
  const isDone = firstStates[of].value === "done";
  return (
    <li>
      <button type="button" data-next={isNext} onClick={() => void doFirst(of)}>
        {isDone ? <DoneStepIcon /> : <OpenStepIcon />}
        <span>{say.steps[of]}</span>
        {isDone && <span class="unseen">{say.isDone}</span>}
      </button>
    </li>
  );
}
