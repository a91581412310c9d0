// The quiet line at the foot of the stage: how long things are, and where the pointer is.

import type { ReadonlySignal } from "@preact/signals";
import { language } from "../state/settings";
import type { Camera } from "./camera";
import { barFor, coordinateText, lengthText } from "./ruler";
import { pointer } from "./tool";

/** The scale bar and the coordinates of the pointer; nothing for screen readers, which have no pixels. */
export function Corner({ camera }: { camera: ReadonlySignal<Camera> }) {
  return (
    <div class="stage-corner" aria-hidden="true">
      <ScaleBar camera={camera} />
      <Coordinates />
    </div>
  );
}

function ScaleBar({ camera }: { camera: ReadonlySignal<Camera> }) {
  const { length, pixels } = barFor(camera.value.scale);
  return (
    <span class="stage-scale">
      <span class="stage-bar" style={{ width: `${pixels.toFixed(1)}px` }} />
      {lengthText(length, language.value)}
    </span>
  );
}

function Coordinates() {
  const at = pointer.value;
  if (!at) return null;
  return (
    <span class="stage-coordinates">
      <i>x</i> {coordinateText(at.x, at.pixel, language.value)} <i>y</i>{" "}
      {coordinateText(at.y, at.pixel, language.value)}
    </span>
  );
}
