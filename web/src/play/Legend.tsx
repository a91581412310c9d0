// What the colours of the timeline mean; only of what there is.

import { words } from "../words";
import { momentKinds, moments, ticks } from "./moments";

export function Legend() {
  const { legend } = words.value.play;
  const there = momentKinds.filter((kind) => moments.value[kind]?.some((count) => count > 0));
  const shown = ticks.value.length > 0 ? ([...there, "breakpoint"] as const) : there;
  return (
    <ul class="legend quiet">
      {shown.map((kind) => (
        <li key={kind}>
          <span class={`swatch swatch-${kind}`} />
          {legend[kind]}
        </li>
      ))}
    </ul>
  );
}
