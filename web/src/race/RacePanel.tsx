// Several algorithms beside each other.

import { words } from "../words";

export function RacePanel() {
  const say = words.value.race;
  return (
    <section aria-labelledby="race-heading">
      <h2 id="race-heading">{say.heading}</h2>
    </section>
  );
}
