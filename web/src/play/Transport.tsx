// The buttons and the slider below the stage.

import { isPlaying, position, run, seek } from "../state/play";
import { number, words } from "../words";
import "./clock";
import "./play.css";

export function Transport() {
  const say = words.value.play;
  const length = run.value?.length ?? 0;
  const at = position.value;
  const toggle = () => {
    isPlaying.value = !isPlaying.value;
  };
  return (
    <div class="transport">
      <button type="button" aria-label={say.first} disabled={at === 0} onClick={() => seek(0)}>
        ⏮
      </button>
      <button type="button" aria-label={say.previous} disabled={at === 0} onClick={() => seek(at - 1)}>
        ◀
      </button>
      <button type="button" disabled={length === 0} onClick={toggle}>
        {isPlaying.value ? say.pause : say.play}
      </button>
      <button type="button" aria-label={say.next} disabled={at === length} onClick={() => seek(at + 1)}>
        ▶
      </button>
      <button type="button" aria-label={say.last} disabled={at === length} onClick={() => seek(length)}>
        ⏭
      </button>
      <input
        type="range"
        aria-label={say.position}
        min={0}
        max={length}
        value={at}
        onInput={(event) => seek(event.currentTarget.valueAsNumber)}
      />
      <span class="figure">{say.of(number(at), number(length))}</span>
    </div>
  );
}
