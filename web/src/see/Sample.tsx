// What an overlay looks like, very small.

import type { ComponentChildren } from "preact";
import type { Palette } from "../stage/palette";
import type { Swatch } from "./overlays";

const shapes: Record<Swatch, ComponentChildren> = {
  area: (
    <path
      d="M3 12 9 3h8l4 9z"
      fill="currentColor"
      fill-opacity="0.35"
      stroke="currentColor"
      stroke-dasharray="2 2.5"
    />
  ),
  line: <path d="M2 11 9 4l5 5 8-5" fill="none" stroke="currentColor" stroke-width="2" />,
  dash: <path d="M2 11 22 4" fill="none" stroke="currentColor" stroke-width="2.5" stroke-dasharray="5 3" />,
  ring: (
    <circle
      cx="12"
      cy="7.5"
      r="5.5"
      fill="currentColor"
      fill-opacity="0.15"
      stroke="currentColor"
      stroke-width="1.75"
    />
  ),
  dot: (
    <>
      <circle cx="4.5" cy="7.5" r="3" class="sample-good" />
      <path d="m9.25 4.75 5.5 5.5m0-5.5-5.5 5.5" class="sample-bad" stroke-width="2" stroke-linecap="round" />
      <circle cx="19.5" cy="7.5" r="2.75" class="sample-asked" stroke-width="2" />
    </>
  ),
  arrow: (
    <>
      <path d="M2 10Q9 3 16 7" fill="none" stroke="currentColor" stroke-width="2" />
      <path d="m22 9.5-8-.5 3-5z" fill="currentColor" />
    </>
  ),
  way: (
    <>
      <path d="m3 11 6-6 6 5 6-7" fill="none" stroke="currentColor" stroke-width="1.5" />
      <path
        d="M3 11h.01M9 5h.01M15 10h.01M21 3h.01"
        stroke="currentColor"
        stroke-width="4.5"
        stroke-linecap="round"
      />
    </>
  ),
  number: (
    <>
      <rect
        x="4"
        y="1.5"
        width="16"
        height="12"
        rx="6"
        fill="none"
        stroke="currentColor"
        stroke-width="1.25"
      />
      <path d="m10.5 5.5 2-1.2v6.5" fill="none" stroke="currentColor" stroke-width="1.5" />
    </>
  ),
};

/** Shows a sample in a colour of the stage. */
export function Sample({ swatch, colour }: { swatch: Swatch; colour: keyof Palette }) {
  return (
    <svg class="sample" viewBox="0 0 24 15" aria-hidden="true" style={{ color: `var(--stage-${colour})` }}>
      {shapes[swatch]}
    </svg>
  );
}
