// The triangles that are not as asked for, and why not.

import { signal, useSignalEffect } from "@preact/signals";
import type { Explanation, Shortfall } from "../engine/protocol";
import { lookAt } from "../stage/attention";
import { boxOf } from "../stage/camera";
import { askMesh, mesh } from "../state/mesh";
import { count as whole, words } from "../words";
import { highlight } from "./colours";
import { choose } from "./inspect";
import { degrees } from "./writing";

/** How many are listed. */
const FIRST = 100;

/** How much of its surroundings is seen of a triangle: so many times as wide. */
const AROUND = 4;

/** Those that are listed. */
const listed = signal<Explanation[]>([]);

export function Unmet() {
  const say = words.value.mesh.unmet;
  useSignalEffect(() => {
    const now = mesh.value;
    listed.value = [];
    if (!now || now.unmet.length === 0) return;
    const first = [...now.unmet.subarray(0, FIRST)];
    void askMesh((engine) => Promise.all(first.map((t) => engine.meshes.explain(t)))).then((all) => {
      if (all) listed.value = all;
    });
  });
  const count = mesh.value?.unmet.length ?? 0;
  return (
    <section aria-labelledby="mesh-unmet">
      <h3 id="mesh-unmet">{say.heading}</h3>
      {count === 0 ? <p class="quiet mesh-small">{say.none}</p> : <List count={count} />}
    </section>
  );
}

function List({ count }: { count: number }) {
  const say = words.value.mesh.unmet;
  const isShown = highlight.value === "unmet";
  return (
    <>
      <p class="mesh-small">
        <button
          type="button"
          aria-pressed={isShown}
          onClick={() => {
            highlight.value = isShown ? null : "unmet";
          }}
        >
          {say.show}
        </button>{" "}
        {count > FIRST && <span class="quiet">{say.first(whole(FIRST), whole(count))}</span>}
      </p>
      <ul class="mesh-unmet">
        {listed.value.map(
          (each) =>
            each.unmet && (
              <li key={each.triangle}>
                <Entry of={each} unmet={each.unmet} />
              </li>
            ),
        )}
      </ul>
    </>
  );
}

function Entry({ of, unmet }: { of: Explanation; unmet: Shortfall }) {
  const say = words.value.mesh.unmet;
  return (
    <button type="button" class={unmet.excused ? "" : "bad"} onClick={() => show(of)}>
      <span class="figure">{whole(of.triangle)}</span>
      <span class="figure">{degrees(Math.min(...of.angles))}</span>
      <span>
        {unmet.broken
          .split(" ")
          .map((each) => say.broken[each] ?? each)
          .join(", ")}
        : {say.reasons[unmet.reason]}
      </span>
    </button>
  );
}

/** Asks about a triangle, and brings it into view. */
function show({ triangle, vertices }: Explanation): void {
  const { low, high } = boxOf(Float64Array.from(vertices.flatMap(({ at }) => at)));
  const by = (AROUND / 2) * Math.max(high[0] - low[0], high[1] - low[1]);
  lookAt({ low: [low[0] - by, low[1] - by], high: [high[0] + by, high[1] + by] });
  choose(triangle);
}
