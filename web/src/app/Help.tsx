// The help: what to begin with, and all keys.

import { Dialog } from "../files/Dialog";
import { dialog } from "../files/dialogs";
import { modes } from "../state/mode";
import { words } from "../words";
import { isFirstMinuteShown } from "./firstMinute";
import { listed, type Where } from "./shortcuts";
import "./help";
import "./help.css";

const places: Where[] = ["page", ...modes, "drawing", "stage"];

export function Help() {
  return (
    <Dialog name="help" heading={words.value.help.heading}>
      <Begin />
      <div class="key-lists">
        {places.map((where) => (
          <Keys key={where} of={where} />
        ))}
      </div>
    </Dialog>
  );
}

function Begin() {
  const say = words.value.help;
  return (
    <p class="help-begin">
      <a href="./guide/index.html">{say.guide}</a>
      <button
        type="button"
        onClick={() => {
          isFirstMinuteShown.value = "shown";
          dialog.value = null;
        }}
      >
        {say.firstMinute}
      </button>
    </p>
  );
}

function Keys({ of }: { of: Where }) {
  const say = words.value.help;
  const rows = listed(of);
  if (rows.length === 0) return null;
  return (
    <section class="keys">
      <h3>{say.places[of]}</h3>
      <dl>
        {rows.map(({ does, keys }) => (
          <div key={does}>
            <dt>{say.does[does]}</dt>
            <dd>
              {keys.map((each) => (
                <Combination key={each} of={each} />
              ))}
            </dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

/** Keys that are pressed together. */
function Combination({ of }: { of: string }) {
  const { keys } = words.value.help;
  const parts = of === "+" ? ["+"] : of.split(/\+(?=.)/);
  return (
    <span class="combination">
      {parts.map((part) => (
        <kbd key={part}>{keys[part] ?? part.toUpperCase()}</kbd>
      ))}
    </span>
  );
}
