// How the page looks and speaks.

import { language, type Theme, theme } from "../state/settings";
import { words } from "../words";

const themes: Theme[] = ["auto", "light", "dark"];

export function Looks() {
  const say = words.value.app;
  return (
    <>
      <label class="look">
        <span>{say.language}</span>
        <select
          value={language.value}
          title={say.language}
          onChange={(event) => {
            language.value = event.currentTarget.value === "de" ? "de" : "en";
          }}
        >
          <option value="en">English</option>
          <option value="de">Deutsch</option>
        </select>
      </label>
      <label class="look">
        <span>{say.theme}</span>
        <select
          value={theme.value}
          title={say.theme}
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
    </>
  );
}
