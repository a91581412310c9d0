// Where playing stops: a list, and a form to add to it.

import { useSignal } from "@preact/signals";
import { CloseIcon, NextIcon, PreviousIcon } from "../app/icons";
import { addBreakpoint, breakpoints, removeBreakpoint, switchBreakpoint } from "../state/breakpoints";
import { position, shownRun } from "../state/play";
import { words } from "../words";
import { Button } from "./Button";
import { sayCondition } from "./conditions";
import { jumpTo } from "./keys";
import { conditionOf, needs, type Offer, offers } from "./offers";

export function Breakpoints() {
  const say = words.value.play.breakpoints;
  const all = breakpoints.value;
  return (
    <details class="fold">
      <summary>
        {say.heading}
        {all.length > 0 && <span class="badge">{all.length}</span>}
      </summary>
      {all.length === 0 ? <p class="quiet">{say.none}</p> : <List />}
      <Form />
    </details>
  );
}

function List() {
  const say = words.value.play.breakpoints;
  return (
    <>
      <ul class="stops">
        {breakpoints.value.map(({ id, condition, isOn }) => (
          <li key={id}>
            <label>
              <input type="checkbox" checked={isOn} onChange={() => switchBreakpoint(id)} />
              {sayCondition(condition)}
            </label>
            <button
              type="button"
              class="tool"
              aria-label={`${say.remove}: ${sayCondition(condition)}`}
              title={say.remove}
              onClick={() => removeBreakpoint(id)}
            >
              <CloseIcon />
            </button>
          </li>
        ))}
      </ul>
      <div class="jumps">
        <Button
          label={say.previous}
          keys="⇧ B"
          isOff={position.value === 0}
          act={() => jumpTo("previous", "breakpoint")}
        >
          <PreviousIcon />
        </Button>
        <Button
          label={say.next}
          keys="B"
          isOff={position.value === (shownRun.value?.length ?? 0)}
          act={() => jumpTo("next", "breakpoint")}
        >
          <NextIcon />
        </Button>
      </div>
    </>
  );
}

function Form() {
  const say = words.value.play.breakpoints;
  const offer = useSignal<Offer>("flip");
  const first = useSignal(Number.NaN);
  const second = useSignal(Number.NaN);
  const condition = conditionOf(offer.value, first.value, second.value);
  const labels = {
    flip: [],
    stage: [],
    vertex: [say.vertex],
    edge: [say.from, say.to],
    conflicts: [say.than],
    line: [say.line],
  }[offer.value];
  return (
    <form
      class="add-stop"
      onSubmit={(event) => {
        event.preventDefault();
        if (condition) addBreakpoint(condition);
      }}
    >
      <select
        aria-label={say.kind}
        value={offer.value}
        onChange={(event) => {
          offer.value = event.currentTarget.value as Offer;
        }}
      >
        {offers.map((each) => (
          <option key={each} value={each}>
            {say.kinds[each]}
          </option>
        ))}
      </select>
      {[first, second].slice(0, needs[offer.value]).map((field, i) => (
        <input
          key={i}
          type="number"
          min="0"
          step={offer.value === "conflicts" ? "any" : 1}
          aria-label={labels[i]}
          placeholder={labels[i]}
          value={Number.isNaN(field.value) ? "" : field.value}
          onInput={(event) => {
            field.value = event.currentTarget.valueAsNumber;
          }}
        />
      ))}
      <button type="submit" disabled={condition === null}>
        {say.add}
      </button>
    </form>
  );
}
