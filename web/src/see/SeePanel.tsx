// The switches of what can be shown over the stage, in groups, each with a sample of what it looks like.

import { signal } from "@preact/signals";
import { mode } from "../state/mode";
import { isLifted, reset, toggle } from "../state/see";
import { words } from "../words";
import { all, groups, type SeeName, type Seen, switched } from "./overlays";
import { Sample } from "./Sample";
import { isShown } from "./shown";
import { WaitingList } from "./WaitingList";
import "./see.css";

/** The switch that is pointed at, or has the focus: what it shows stands below. */
const explained = signal<SeeName | "lift" | null>(null);

/** The place of the explanation, which describes the switch. */
const ABOUT = "see-about";

export function SeePanel() {
  const here = all.filter(({ modes }) => modes.includes(mode.value));
  if (here.length === 0) return null;
  const say = words.value.see;
  return (
    <section aria-labelledby="see-heading" class="see">
      <header>
        <h2 id="see-heading">{say.heading}</h2>
        <button type="button" class="see-reset" onClick={reset}>
          {say.reset}
        </button>
      </header>
      {groups.map((group) => (
        <Group key={group} name={group} seen={here.filter((each) => each.group === group)} />
      ))}
      <p id={ABOUT} class="quiet see-about">
        {aboutOf(explained.value)}
      </p>
      <WaitingList />
    </section>
  );
}

function aboutOf(name: SeeName | "lift" | null): string {
  const say = words.value.see;
  if (name === "lift") return say.lift.about;
  return name ? say.about[name] : say.hint;
}

function Group({ name, seen }: { name: (typeof groups)[number]; seen: Seen[] }) {
  if (seen.length === 0) return null;
  return (
    <fieldset>
      <legend>{words.value.see.groups[name]}</legend>
      {seen.map((each) => (
        <Switch key={each.name} of={each} />
      ))}
      {name === "geometry" && <LiftSwitch />}
    </fieldset>
  );
}

function Switch({ of }: { of: Seen }) {
  const { name, swatch, colour } = of;
  const say = words.value.see;
  return (
    <label {...explaining(name)} title={say.about[name]}>
      <input
        type="checkbox"
        checked={switched.value.has(name)}
        aria-describedby={ABOUT}
        onChange={() => toggle(name)}
      />
      <Sample swatch={swatch} colour={colour} />
      <span>{say.names[name]}</span>
    </label>
  );
}

function LiftSwitch() {
  const say = words.value.see.lift;
  return (
    <button
      type="button"
      class="see-lift"
      aria-pressed={isLifted.value}
      disabled={!isShown.value}
      title={say.about}
      onClick={() => {
        isLifted.value = !isLifted.value;
      }}
      {...explaining("lift")}
    >
      {say.show}
    </button>
  );
}

/** Explains something while it is pointed at or has the focus. */
function explaining(name: SeeName | "lift") {
  const set = (next: typeof name | null) => () => {
    explained.value = next;
  };
  return {
    onPointerEnter: set(name),
    onPointerLeave: set(null),
    onFocusIn: set(name),
    onFocusOut: set(null),
  };
}
