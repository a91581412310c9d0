// The panels: what is drawn and what is shown of it at the left, what is done with it at the right.

import type { ComponentChildren } from "preact";
import { DrawingPanel } from "../drawing/DrawingPanel";
import { MeshPanel } from "../mesh/MeshPanel";
import { PlayPanel } from "../play/PlayPanel";
import { PredictPanel } from "../predict/PredictPanel";
import { RacePanel } from "../race/RacePanel";
import { SeePanel } from "../see/SeePanel";
import { mode } from "../state/mode";
import { words } from "../words";
import { FirstMinute } from "./FirstMinute";
import { isSeen, isSingle, type Panel } from "./layout";

const works = { play: PlayPanel, predict: PredictPanel, race: RacePanel, mesh: MeshPanel };

export function Left() {
  return (
    <aside class="side" aria-label={words.value.app.left} hidden={!isSeen("drawing") && !isSeen("see")}>
      <div class="scroll">
        <PanelBody name="drawing">
          <DrawingPanel />
        </PanelBody>
        <PanelBody name="see">
          <SeePanel />
        </PanelBody>
      </div>
      {!isSingle.value && <FirstMinute />}
    </aside>
  );
}

export function Right() {
  const Work = works[mode.value];
  return (
    <aside class="work" aria-label={words.value.app.right} hidden={!isSeen("work")}>
      <div class="scroll">
        <PanelBody name="work">
          <Work />
        </PanelBody>
      </div>
    </aside>
  );
}

/** What belongs together where there is room for one panel at a time only. */
function PanelBody({ name, children }: { name: Panel; children: ComponentChildren }) {
  return (
    <div class="panel" id={`panel-${name}`} hidden={isSingle.value && !isSeen(name)}>
      {children}
    </div>
  );
}
