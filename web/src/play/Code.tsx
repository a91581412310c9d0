// The pseudocode: the line that runs is marked and kept in sight, a click on a line stops playing there.

import { useEffect, useRef } from "preact/hooks";
import { onLine, toggleLine } from "../state/breakpoints";
import { algorithm, frame, shownRun } from "../state/play";
import { words } from "../words";

/** Lines that are kept in sight above and below the one that runs. */
const AROUND = 30;

export function Code() {
  const pane = useRef<HTMLOListElement>(null);
  const running = frame.value?.step?.line ?? 0;
  const lines = shownRun.value?.code ?? algorithm.value?.code ?? [];
  const say = words.value.play;
  useEffect(() => {
    if (pane.current) keepInSight(pane.current, running);
  }, [running]);
  return (
    <section aria-labelledby="code-heading">
      <h2 id="code-heading">{say.code}</h2>
      <ol class="code" ref={pane} aria-labelledby="code-heading" title={say.codeHint}>
        {lines.map((line, i) => (
          <Line key={i} number={i + 1} text={line} isRunning={i + 1 === running} />
        ))}
      </ol>
    </section>
  );
}

function Line({ number, text, isRunning }: { number: number; text: string; isRunning: boolean }) {
  const isStop = onLine(number)?.isOn ?? false;
  const indent = text.length - text.trimStart().length;
  return (
    <li aria-current={isRunning ? "step" : undefined}>
      <button
        type="button"
        class="code-line"
        title={words.value.play.lineBreak(number)}
        aria-pressed={isStop}
        onClick={() => toggleLine(number)}
      >
        <span class="code-dot" />
        <span class="code-number">{number}</span>
        <code style={{ paddingLeft: `${indent}ch` }}>{text.trimStart()}</code>
      </button>
    </li>
  );
}

// Only the pane moves, never the page.
function keepInSight(pane: HTMLElement, line: number): void {
  const item = pane.children[line - 1];
  if (!(item instanceof HTMLElement)) return;
  const [top, bottom] = [item.offsetTop - AROUND, item.offsetTop + item.offsetHeight + AROUND];
  if (top < pane.scrollTop) pane.scrollTop = top;
  else if (bottom > pane.scrollTop + pane.clientHeight) pane.scrollTop = bottom - pane.clientHeight;
}
