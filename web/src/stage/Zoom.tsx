// The buttons that move the view.

import { FitIcon, MinusIcon, PlusIcon } from "../app/icons";
import { words } from "../words";
import { ZOOM } from "./keys";
import type { View } from "./view";

export function Zoom({ view }: { view: View }) {
  const say = words.value.stage;
  return (
    <fieldset class="stage-zoom" aria-label={say.view}>
      <button
        type="button"
        aria-label={say.zoomIn}
        title={`${say.zoomIn} (+)`}
        onClick={() => view.zoomBy(ZOOM)}
      >
        <PlusIcon />
      </button>
      <button
        type="button"
        aria-label={say.zoomOut}
        title={`${say.zoomOut} (−)`}
        onClick={() => view.zoomBy(1 / ZOOM)}
      >
        <MinusIcon />
      </button>
      <button type="button" aria-label={say.fit} title={`${say.fit} (0)`} onClick={() => view.glide(null)}>
        <FitIcon />
      </button>
    </fieldset>
  );
}
