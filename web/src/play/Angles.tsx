// How many triangles have which smallest angle, in the scene that is shown.

import { signal, useSignal, useSignalEffect } from "@preact/signals";
import { stage } from "../engine/client";
import { jobOf } from "../state/job";
import { tell } from "../state/notices";
import { algorithm, askRun, frame, run } from "../state/play";
import { count, words } from "../words";
import { isAboutAngles } from "./wants";

/** Angles below this are counted in words. */
const SMALL = 20;

const BINS = 60;

const angles = signal<Uint32Array | null>(null);

let isAsking = false;

// One question at a time, and then for the scene that is shown by now.
async function follow(): Promise<void> {
  isAsking = true;
  try {
    for (;;) {
      const at = frame.peek()?.position;
      if (at === undefined || !run.peek() || jobOf(stage).peek()) return;
      angles.value = await askRun(({ players }, slot) => players.angles(slot, at));
      if (frame.peek()?.position === at) return;
    }
  } catch (error) {
    tell(error);
  } finally {
    isAsking = false;
  }
}

export function Angles() {
  const say = words.value.play.angles;
  // Open of its own accord where angles are what it is about.
  const isAbout = algorithm.value !== undefined && isAboutAngles(algorithm.value);
  const opened = useSignal<boolean | null>(null);
  const isOpen = opened.value ?? isAbout;
  return (
    <details
      class="fold"
      open={isOpen}
      onToggle={(event) => {
        if (event.currentTarget.open !== isOpen) opened.value = event.currentTarget.open;
      }}
    >
      <summary>{say.heading}</summary>
      {isOpen && <Histogram />}
    </details>
  );
}

function Histogram() {
  useSignalEffect(() => {
    void frame.value;
    if (!isAsking) void follow();
  });
  const say = words.value.play.angles;
  const counts = Array.from(angles.value ?? new Uint32Array(BINS));
  const total = counts.reduce((a, b) => a + b, 0);
  const below = counts.slice(0, SMALL).reduce((a, b) => a + b, 0);
  const most = Math.max(1, ...counts);
  return (
    <figure class="angles">
      <svg
        role="img"
        aria-label={say.said(count(total), count(below))}
        viewBox="0 0 60 24"
        preserveAspectRatio="none"
      >
        {counts.map((value, degree) => (
          <rect
            key={degree}
            class={degree < SMALL ? "small" : undefined}
            x={degree + 0.08}
            width={0.84}
            y={24 - (24 * value) / most}
            height={(24 * value) / most}
          />
        ))}
      </svg>
      <div class="angles-axis figure" aria-hidden="true">
        <span>0°</span>
        <span>20°</span>
        <span>40°</span>
        <span>60°</span>
      </div>
      <figcaption class="quiet">{say.said(count(total), count(below))}</figcaption>
    </figure>
  );
}
