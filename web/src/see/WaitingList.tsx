// What waits, as a list.

import { count, words } from "../words";
import { fromFirst, type Waiter } from "./waiters";
import { waiters } from "./waiting";

/** How many are listed. */
const MOST = 12;

export function WaitingList() {
  const all = waiters.value;
  if (all.length === 0) return null;
  const say = words.value.see.waiting;
  const names = [...new Set(all.map(({ queue }) => say.queues[queue]))].join(", ");
  const listed = fromFirst(all, MOST);
  const rest = all.length - listed.length;
  return (
    <div class="waiting">
      <h3>
        {say.heading} <span class="quiet">{`${names}: ${count(all.length)}`}</span>
      </h3>
      <ol>
        {listed.map((waiter, i) => (
          <li key={i} class={waiter.isNext ? "first" : undefined}>
            <span class="figure rank">{waiter.rank || "·"}</span>
            <span class="figure">{nameOf(waiter)}</span>
            {waiter.isNext && <span class="quiet">{say.next}</span>}
          </li>
        ))}
      </ol>
      {rest > 0 && <p class="quiet">{say.more(count(rest))}</p>}
    </div>
  );
}

function nameOf({ vertices }: Waiter): string {
  const say = words.value.see.waiting;
  const [a, b, c] = vertices.map(String);
  if (vertices.length === 1) return say.vertex(a);
  return vertices.length === 2 ? say.edge(a, b) : say.triangle(a, b, c);
}
