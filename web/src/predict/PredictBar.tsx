// What is below the stage in the game: the question, the answers to choose from, and the verdict.

import { useLayoutEffect, useRef } from "preact/hooks";
import { bind } from "../app/shortcuts";
import { run } from "../state/play";
import {
  answered,
  ask,
  askNext,
  cursor,
  difficulty,
  guess,
  guessable,
  isHinted,
  isOver,
  puzzle,
} from "../state/predict";
import { words } from "../words";
import { keyOf } from "./edges";
import { explain } from "./explain";
import "./predict.css";

export function PredictBar() {
  const say = words.value.predict;
  const bar = useRef<HTMLElement>(null);
  const isTold = answered.value !== null;
  // Whoever answers by keyboard goes on there: the button that was pressed is gone. At once with the verdict: Enter
  // pressed on seeing it must not go to what had the focus before.
  useLayoutEffect(() => {
    const wasLost = document.activeElement === document.body;
    if (isTold) bar.current?.querySelector<HTMLElement>(".main")?.focus({ preventScroll: true });
    else if (wasLost) bar.current?.focus({ preventScroll: true });
  }, [isTold]);
  return (
    <section class="predict-bar" aria-label={say.bar} ref={bar} tabIndex={-1}>
      <Message />
      <div class="predict-buttons">
        {isOver.value ? (
          <button type="button" class="main" onClick={() => void ask(0)}>
            {say.again}
          </button>
        ) : answered.value ? (
          <button type="button" class="main" onClick={askNext}>
            {say.next}
          </button>
        ) : (
          <Choices />
        )}
      </div>
    </section>
  );
}

function Message() {
  const say = words.value.predict;
  const told = answered.value;
  const isWithout = run.value?.tally.flips === 0;
  return (
    <div class="predict-message" aria-live="polite">
      {told && <strong class={`verdict ${told.verdict}`}>{say.verdicts[told.verdict]}</strong>}{" "}
      {told && puzzle.value
        ? explain(told, puzzle.value, say)
        : isOver.value
          ? isWithout
            ? say.noFlips
            : say.over
          : puzzle.value
            ? say.ask[difficulty.value]
            : say.loading}
    </div>
  );
}

function Choices() {
  const say = words.value.predict;
  const isReady = puzzle.value !== null;
  return (
    <>
      {difficulty.value === "three" && (
        <fieldset class="choices" aria-label={say.choices}>
          {guessable.value.map((quad, i) => (
            <button key={keyOf(quad.edge)} type="button" onClick={() => void guess(quad)}>
              <kbd>{i + 1}</kbd>
              {keyOf(quad.edge)}
            </button>
          ))}
        </fieldset>
      )}
      <button
        type="button"
        title={`${say.hintHint} (H)`}
        aria-pressed={isHinted.value}
        disabled={!isReady}
        onClick={hint}
      >
        {say.hint}
      </button>
      <button type="button" disabled={!isReady} onClick={skip}>
        {say.skip}
      </button>
    </>
  );
}

function hint(): void {
  isHinted.value = true;
}

function skip(): void {
  if (puzzle.peek()) void ask(puzzle.peek()!.flip);
}

function move(by: number): void {
  const all = guessable.value.length;
  if (all > 0) cursor.value = (cursor.value + by + (cursor.value < 0 && by < 0 ? 1 : 0) + all) % all;
}

function enter(): void {
  if (isOver.value) void ask(0);
  else if (answered.value) askNext();
  else if (guessable.value[cursor.value]) void guess(guessable.value[cursor.value]);
}

for (const place of [0, 1, 2])
  bind("predict", String(place + 1), "guess", () => {
    const quad = difficulty.value === "three" ? guessable.value[place] : undefined;
    if (quad) void guess(quad);
  });
bind("predict", "ArrowRight", "nextEdge", () => move(1));
bind("predict", "ArrowLeft", "previousEdge", () => move(-1));
bind("predict", "Enter", "answer", enter);
bind("predict", " ", "answer", enter);
bind("predict", "h", "hint", hint);
