// The head of the page: what to do, which panels are there, and a menu.

import { type Mode, mode, modes } from "../state/mode";
import { words } from "../words";
import { LeftPanelIcon, Logo, RightPanelIcon } from "./icons";
import { hasLeft, hasRight, isSingle, toggle } from "./layout";
import { Menu } from "./Menu";
import "./header.css";

export function Header() {
  const say = words.value.app;
  return (
    <header class="head">
      <button type="button" class="skip" onClick={skip}>
        {say.skip}
      </button>
      <h1 class="name">
        <Logo />
        <span>Delone</span>
      </h1>
      {!isSingle.value && <Fold icon={LeftPanelIcon} label={say.left} shown={hasLeft} />}
      <nav class="modes" aria-label={say.mode}>
        {modes.map((each) => (
          <ModeButton key={each} of={each} />
        ))}
      </nav>
      <Menu />
      {!isSingle.value && <Fold icon={RightPanelIcon} label={say.right} shown={hasRight} />}
    </header>
  );
}

function ModeButton({ of }: { of: Mode }) {
  const { modes: names, modeHints } = words.value.app;
  const isOn = mode.value === of;
  return (
    <button
      type="button"
      class="tab"
      aria-current={isOn ? "page" : undefined}
      title={modeHints[of]}
      onClick={() => {
        mode.value = of;
      }}
    >
      {names[of]}
    </button>
  );
}

interface FoldProps {
  icon: typeof LeftPanelIcon;
  label: string;
  shown: typeof hasLeft;
}

/** Folds the panels of one side away. */
function Fold({ icon: Icon, label, shown }: FoldProps) {
  return (
    <button
      type="button"
      class="icon-button"
      aria-expanded={shown.value === "shown"}
      aria-label={label}
      title={label}
      onClick={() => toggle(shown)}
    >
      <Icon />
    </button>
  );
}

// The address is a deep link of its own: no link to a place on the page, the focus goes by hand.
function skip(): void {
  document.getElementById("stage")?.focus();
}
