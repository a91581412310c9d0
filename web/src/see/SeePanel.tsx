// The switches of what can be shown over the stage.

import { mode } from "../state/mode";
import { words } from "../words";
import { all, type SeeName, switched } from "./overlays";

export function SeePanel() {
  const say = words.value.see;
  const here = all.filter(({ modes }) => modes.includes(mode.value));
  if (here.length === 0) return null;
  return (
    <section aria-labelledby="see-heading">
      <h2 id="see-heading">{say.heading}</h2>
      {here.map(({ name }) => (
        <label key={name} class="field">
          <input type="checkbox" checked={switched.value.has(name)} onChange={() => toggle(name)} />
          {say[name]}
        </label>
      ))}
    </section>
  );
}

function toggle(name: SeeName): void {
  const next = new Set(switched.value);
  if (!next.delete(name)) next.add(name);
  switched.value = next;
}
