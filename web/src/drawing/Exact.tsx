// Drawing by numbers: exact coordinates, for those who have them, or no pointer.

import { useRef } from "preact/hooks";
import type { Edit } from "../engine/protocol";
import { edit } from "../state/drawing";
import { words } from "../words";

export function Exact() {
  const say = words.value.drawing;
  const place = useRef<HTMLFormElement>(null);
  const ends = useRef<HTMLFormElement>(null);
  return (
    <details>
      <summary>{say.exact}</summary>
      <form ref={place} class="exact" onSubmit={(event) => event.preventDefault()}>
        <label>
          x <input name="first" type="number" step="any" required />
        </label>
        <label>
          y <input name="second" type="number" step="any" required />
        </label>
        <button type="submit" onClick={() => add(place.current!, (x, y) => ({ addPoint: [x, y] }))}>
          {say.addPoint}
        </button>
        <button type="button" onClick={() => add(place.current!, (x, y) => ({ addHole: [x, y] }))}>
          {say.addHole}
        </button>
      </form>
      <form ref={ends} class="exact" onSubmit={(event) => event.preventDefault()}>
        <label>
          {say.from} <input name="first" type="number" min="0" step="1" required />
        </label>
        <label>
          {say.to} <input name="second" type="number" min="0" step="1" required />
        </label>
        <button type="submit" onClick={() => add(ends.current!, (a, b) => ({ addSegment: [a, b] }))}>
          {say.addSegment}
        </button>
      </form>
    </details>
  );
}

/** Makes the edit of two numbers, if both are there. */
function add(form: HTMLFormElement, make: (first: number, second: number) => Edit): void {
  if (!form.checkValidity()) return;
  const [first, second] = ["first", "second"].map((name) => Number(new FormData(form).get(name)));
  void edit(make(first, second));
}
