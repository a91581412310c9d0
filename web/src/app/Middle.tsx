// The middle of the page: the stage, what is said over it, and what moves the run below.

import { Toolbar, ToolHint } from "../drawing/Toolbar";
import { Transport } from "../play/Transport";
import { PredictBar } from "../predict/PredictBar";
import { RaceBar } from "../race/RaceBar";
import { inHand } from "../stage/tools/box";
import { mode } from "../state/mode";
import { Jobs } from "./Jobs";
import { Loading } from "./Loading";
import { isSingle, openPanel } from "./layout";
import { Notices } from "./Notices";
import { readiness } from "./readiness";
import { Stages } from "./Stages";

const bars = { play: Transport, predict: PredictBar, race: RaceBar, mesh: null };

export function Middle() {
  const Bar = bars[mode.value];
  // In little room, and over the heads of racers, the tools are there for whoever draws.
  const hasRoom = !isSingle.value && mode.value !== "race";
  const hasTools = hasRoom || openPanel.value === "drawing" || inHand.value !== "view";
  return (
    <main class="middle" id="stage" tabIndex={-1}>
      <Stages />
      {hasTools && <Toolbar />}
      <ToolHint />
      <Loading />
      <Jobs />
      {typeof readiness.value === "string" && <Notices />}
      {Bar && <Bar />}
    </main>
  );
}
