// The page: its head, the drawing on the left, the stage in the middle, what is done with it on the right.

import { DrawingPanel } from "../drawing/DrawingPanel";
import { Toolbar, ToolHint } from "../drawing/Toolbar";
import { DropZone } from "../files/DropZone";
import { PasteDialog } from "../files/PasteDialog";
import { SaveDialog } from "../files/SaveDialog";
import { MeshPanel } from "../mesh/MeshPanel";
import { PlayPanel } from "../play/PlayPanel";
import { Transport } from "../play/Transport";
import { PredictBar } from "../predict/PredictBar";
import { PredictPanel } from "../predict/PredictPanel";
import { RaceBar } from "../race/RaceBar";
import { RacePanel } from "../race/RacePanel";
import { SeePanel } from "../see/SeePanel";
import { mode } from "../state/mode";
import { Header } from "./Header";
import { Jobs } from "./Jobs";
import { Notices } from "./Notices";
import { Stages } from "./Stages";
import { useShortcuts } from "./shortcuts";
import "./app.css";

const panels = { play: PlayPanel, predict: PredictPanel, race: RacePanel, mesh: MeshPanel };
const bars = { play: Transport, predict: PredictBar, race: RaceBar, mesh: null };

export function App() {
  useShortcuts();
  const Panel = panels[mode.value];
  const Bar = bars[mode.value];
  return (
    <div class="app" data-mode={mode.value}>
      <Header />
      <aside class="side">
        <DrawingPanel />
        <SeePanel />
      </aside>
      <main class="middle" id="stage" tabIndex={-1}>
        <Stages />
        <Toolbar />
        <ToolHint />
        <Jobs />
        <Notices />
        {Bar && <Bar />}
      </main>
      <aside class="work">
        <Panel />
      </aside>
      <DropZone />
      <PasteDialog />
      <SaveDialog />
    </div>
  );
}
