// Guessing the next flip.

import { words } from "../words";

export function PredictPanel() {
  const say = words.value.predict;
  return (
    <section aria-labelledby="predict-heading">
      <h2 id="predict-heading">{say.heading}</h2>
    </section>
  );
}
