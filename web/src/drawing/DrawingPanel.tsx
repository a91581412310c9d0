// The drawing: which one, and what it consists of.

import { drawing } from "../state/drawing";
import { number, words } from "../words";
import { Presets } from "./Presets";

export function DrawingPanel() {
  const say = words.value.drawing;
  const about = drawing.value?.about;
  return (
    <section aria-labelledby="drawing-heading">
      <h2 id="drawing-heading">{say.heading}</h2>
      <Presets />
      {about && (
        <p class="quiet">{say.summary(number(about.points), number(about.segments), number(about.holes))}</p>
      )}
    </section>
  );
}
