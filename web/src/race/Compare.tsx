// All algorithms on this drawing, in a table that can be sorted.

import { useSignal } from "@preact/signals";
import { copy } from "../app/clipboard";
import { CheckIcon } from "../app/icons";
import { titleOf } from "../play/described";
import { compare, type Entry, entries, isComparing, libraryHash, MOST_POINTS } from "../state/compare";
import { drawing } from "../state/drawing";
import { notify } from "../state/notices";
import { count, words } from "../words";
import { columnNames, columns, type Order, sorted, toCsv } from "./columns";
import { milliseconds } from "./writing";

export function Compare() {
  const say = words.value.race.compare;
  const isTooLarge = (drawing.value?.about.points ?? 0) > MOST_POINTS;
  const order = useSignal<Order>({ by: "tests", isDown: false });
  const titled = entries.value.map((entry) => ({ ...entry, title: titleOf(entry.name, entry.title) }));
  const rows = sorted(titled, order.value);
  return (
    <section aria-labelledby="compare-heading">
      <h2 id="compare-heading">{say.heading}</h2>
      <p class="quiet">{isTooLarge ? say.tooMany(count(MOST_POINTS)) : say.intro}</p>
      <div class="jumps">
        <button type="button" disabled={isTooLarge || isComparing.value} onClick={() => void compare()}>
          {rows.length > 0 ? say.again : say.run}
        </button>
        {rows.length > 0 && (
          <button type="button" onClick={() => void take(rows)}>
            {say.copy}
          </button>
        )}
      </div>
      {rows.length > 0 && (
        <>
          <div class="compare">
            <table class="figures">
              <Head order={order.value} put={(next) => (order.value = next)} />
              <tbody>
                {rows.map((row) => (
                  <Row key={row.name} of={row} />
                ))}
              </tbody>
            </table>
          </div>
          <p class="quiet small-print">{say.note}</p>
        </>
      )}
    </section>
  );
}

function Head({ order, put }: { order: Order; put: (order: Order) => void }) {
  const say = words.value.race.compare;
  const toggle = (by: Order["by"]) => put({ by, isDown: order.by === by && !order.isDown });
  return (
    <thead>
      <tr>
        {(["title", ...columnNames] as const).map((name) => (
          <th
            key={name}
            scope="col"
            aria-sort={order.by !== name ? "none" : order.isDown ? "descending" : "ascending"}
          >
            <button type="button" onClick={() => toggle(name)}>
              {say.columns[name]}
            </button>
          </th>
        ))}
      </tr>
    </thead>
  );
}

function Row({ of }: { of: Entry }) {
  const say = words.value.race.compare;
  const isSame = of.measured !== null && of.measured.hash === libraryHash.value;
  return (
    <tr>
      <th scope="row" title={of.error || (isSame ? say.same : say.other)}>
        {of.title}
        {isSame && (
          <span class="same" role="img" aria-label={say.same}>
            <CheckIcon />
          </span>
        )}
        {of.error && <small class="why">{of.error}</small>}
      </th>
      {columnNames.map((name) => {
        const value = columns[name](of);
        const told = name === "milliseconds" ? milliseconds : count;
        return (
          <td key={name} class="figure">
            {value === null ? "–" : told(value)}
          </td>
        );
      })}
    </tr>
  );
}

async function take(rows: Entry[]): Promise<void> {
  if (await copy(toCsv(rows))) notify("info", words.peek().race.compare.copied);
}
