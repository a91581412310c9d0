// The page: its head, the drawing, the stage, and what is done with it. They stand in the order in which they are read,
// so that the focus goes the same way: from left to right where there is room, else from the stage down.

import { DropZone } from "../files/DropZone";
import { PasteDialog } from "../files/PasteDialog";
import { SaveDialog } from "../files/SaveDialog";
import { mode } from "../state/mode";
import { FirstMinute } from "./FirstMinute";
import { Header } from "./Header";
import { Help } from "./Help";
import { hasLeft, hasRight, isSingle, openPanel, size } from "./layout";
import { Middle } from "./Middle";
import { Left, Right } from "./Panels";
import { PanelTabs } from "./PanelTabs";
import { readiness } from "./readiness";
import { useShortcuts } from "./shortcuts";
import "./app.css";
import "./panels.css";

export function App() {
  useShortcuts();
  const stage = <Middle key="stage" />;
  const isWide = size.value === "wide";
  return (
    <div
      class="app"
      data-mode={mode.value}
      data-size={size.value}
      data-ready={readiness.value === "ready"}
      data-left={hasLeft.value}
      data-right={hasRight.value}
      data-open={openPanel.value ?? "none"}
    >
      <Header key="head" />
      {!isWide && stage}
      {isSingle.value && <FirstMinute key="first" isShort />}
      {isSingle.value && <PanelTabs key="tabs" />}
      <Left key="left" />
      {isWide && stage}
      <Right key="right" />
      <DropZone key="drop" />
      <PasteDialog key="paste" />
      <SaveDialog key="save" />
      <Help key="help" />
    </div>
  );
}
