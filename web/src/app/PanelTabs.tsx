// Where there is room for one panel at a time: which one. The button of the open one closes it.

import { mode } from "../state/mode";
import { words } from "../words";
import { openPanel, type Panel, panelsHere } from "./layout";

export function PanelTabs() {
  return (
    <nav class="panel-tabs" aria-label={words.value.app.panels}>
      {panelsHere.value.map((panel) => (
        <PanelTab key={panel} of={panel} />
      ))}
    </nav>
  );
}

function PanelTab({ of }: { of: Panel }) {
  const say = words.value;
  const isOpen = openPanel.value === of;
  return (
    <button
      type="button"
      aria-expanded={isOpen}
      aria-controls={`panel-${of}`}
      onClick={() => {
        openPanel.value = isOpen ? null : of;
      }}
    >
      {of === "work" ? say.app.works[mode.value] : say[of].heading}
    </button>
  );
}
