// The drawing: which one, and what it consists of; others to begin with, to open, and to save.

import { EmptyIcon } from "../app/icons";
import { FileButtons } from "../files/FileButtons";
import { drawing, openEmpty } from "../state/drawing";
import { count, words } from "../words";
import { Exact } from "./Exact";
import { Presets } from "./Presets";
import "./drawing.css";

export function DrawingPanel() {
  const say = words.value.drawing;
  const about = drawing.value?.about;
  return (
    <section aria-labelledby="drawing-heading">
      <h2 id="drawing-heading">{say.heading}</h2>
      <Presets />
      <div class="buttons">
        <button type="button" class="worded" onClick={() => void openEmpty()}>
          <EmptyIcon />
          {say.empty}
        </button>
        <FileButtons />
      </div>
      <p class="quiet about">
        {about ? say.summary(count(about.points), count(about.segments), count(about.holes)) : "\u00a0"}
      </p>
      <Exact />
    </section>
  );
}
