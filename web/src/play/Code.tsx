// The pseudocode, with the line that runs.

import { frame, run } from "../state/play";
import { words } from "../words";
import "./play.css";

export function Code() {
  const running = frame.value?.step?.line ?? 0;
  const lines = run.value?.code ?? [];
  return (
    <ol class="code" aria-label={words.value.play.code}>
      {lines.map((line, i) => (
        <li key={i} aria-current={i + 1 === running ? "step" : undefined}>
          <code>{line}</code>
        </li>
      ))}
    </ol>
  );
}
