// The head of the page: what to do, and how the page looks.

import { LinkButton } from "../files/LinkButton";
import { type Mode, mode, modes } from "../state/mode";
import { language, type Theme, theme } from "../state/settings";
import { words } from "../words";

const themes: Theme[] = ["auto", "light", "dark"];

export function Header() {
  const say = words.value.app;
  return (
    <header class="head">
      <button type="button" class="skip" onClick={skip}>
        {say.skip}
      </button>
      <span class="name">Delone</span>
      <nav aria-label={say.mode}>
        {modes.map((each) => (
          <ModeButton key={each} of={each} />
        ))}
      </nav>
      <LinkButton />
      <label>
        <span class="quiet">{say.language}</span>
        <select
          value={language.value}
          onChange={(event) => {
            language.value = event.currentTarget.value === "de" ? "de" : "en";
          }}
        >
          <option value="en">English</option>
          <option value="de">Deutsch</option>
        </select>
      </label>
      <label>
        <span class="quiet">{say.theme}</span>
        <select
          value={theme.value}
          onChange={(event) => {
            theme.value = event.currentTarget.value as Theme;
          }}
        >
          {themes.map((each) => (
            <option key={each} value={each}>
              {say.themes[each]}
            </option>
          ))}
        </select>
      </label>
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

// The address is a deep link of its own: no link to a place on the page, the focus goes by hand.
function skip(): void {
  document.getElementById("stage")?.focus();
}
