// The tools, at the upper left of the stage, and what takes changes back.

import type { ComponentType } from "preact";
import {
  ClearIcon,
  EraseIcon,
  HolesIcon,
  PointsIcon,
  RedoIcon,
  SegmentsIcon,
  UndoIcon,
  ViewIcon,
} from "../app/icons";
import { inHand, type ToolName, take, toolKeys, toolNames } from "../stage/tools/box";
import { canRedo, canUndo, drawing, edit, redo, undo } from "../state/drawing";
import { words } from "../words";
import "./keys";
import "./drawing.css";

const icons: Record<ToolName, ComponentType> = {
  view: ViewIcon,
  points: PointsIcon,
  segments: SegmentsIcon,
  holes: HolesIcon,
  erase: EraseIcon,
};

export function Toolbar() {
  const say = words.value.drawing;
  const about = drawing.value?.about;
  const isEmpty = !about || about.points + about.segments + about.holes === 0;
  return (
    <fieldset class="tools" aria-label={say.tools.label}>
      {toolNames.map((name) => (
        <ToolButton key={name} name={name} />
      ))}
      <hr />
      <Action label={say.undo} keys={say.keys.undo} icon={UndoIcon} isOff={!canUndo.value} run={undo} />
      <Action label={say.redo} keys={say.keys.redo} icon={RedoIcon} isOff={!canRedo.value} run={redo} />
      <Action label={say.clear} icon={ClearIcon} isOff={isEmpty} run={() => edit({ clear: true })} />
    </fieldset>
  );
}

/** What the tool in hand does, below. */
export function ToolHint() {
  if (inHand.value === "view") return null;
  return (
    <p class="tool-hint" role="status">
      {words.value.drawing.hints[inHand.value]}
    </p>
  );
}

function ToolButton({ name }: { name: ToolName }) {
  const label = words.value.drawing.tools[name];
  const Icon = icons[name];
  return (
    <button
      type="button"
      class="tool"
      aria-label={label}
      aria-pressed={inHand.value === name}
      aria-keyshortcuts={toolKeys[name]}
      title={`${label} (${toolKeys[name].toUpperCase()})`}
      onClick={() => take(name)}
    >
      <Icon />
    </button>
  );
}

interface ActionProps {
  label: string;
  keys?: string;
  icon: ComponentType;
  isOff: boolean;
  run: () => unknown;
}

function Action({ label, keys, icon: Icon, isOff, run }: ActionProps) {
  const title = keys ? `${label} (${keys})` : label;
  return (
    <button
      type="button"
      class="tool"
      aria-label={label}
      title={title}
      disabled={isOff}
      onClick={() => void run()}
    >
      <Icon />
    </button>
  );
}
