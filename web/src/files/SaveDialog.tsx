// Saving: what, in which format, and what matters there.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { stage } from "../engine/client";
import type { Format } from "../engine/protocol";
import { drawing } from "../state/drawing";
import { mesh } from "../state/mesh";
import { mode } from "../state/mode";
import { tell } from "../state/notices";
import { run } from "../state/play";
import { words } from "../words";
import { ChoiceFields } from "./ChoiceFields";
import { type Offered, offered, type What, whats } from "./choices";
import { Dialog } from "./Dialog";
import { dialog, wanted } from "./dialogs";
import { videoExtension } from "./record";
import { type Chosen, save } from "./save";

const usual: Chosen = {
  oneBased: false,
  quadratic: false,
  legend: true,
  changesOnly: false,
  size: 1200,
  seconds: 10,
  frames: 12,
  zip: true,
};

export function SaveDialog() {
  return (
    <Dialog name="save" heading={words.value.files.saveHeading}>
      <SaveForm />
    </Dialog>
  );
}

function SaveForm() {
  const say = words.value.files;
  const formats = useSignal<Format[]>([]);
  const what = useSignal<What>(wanted.peek() ?? (mode.value === "mesh" && mesh.value ? "mesh" : "drawing"));
  const extension = useSignal("");
  const chosen = useSignal<Chosen>(usual);
  useEffect(() => {
    // The next one may be opened without a wish.
    wanted.value = null;
    stage
      .insist((engine) => engine.drawings.formats())
      .then((all) => {
        formats.value = all;
      }, tell);
  }, [formats]);
  const content = drawing.value?.about ?? { segments: 0, holes: 0, regions: 0 };
  const offersNow = () => offered(what.value, formats.value, content, videoExtension());
  const offerOf = (all: Offered[]) => all.find((each) => each.extension === extension.value) ?? all[0];
  const offers = offersNow();
  const offer = offerOf(offers);
  const submit = async (event: Event) => {
    event.preventDefault();
    dialog.value = null;
    // What is chosen by now, though it may not have been drawn yet.
    await save(what.value, offerOf(offersNow()), chosen.value);
  };
  return (
    <form onSubmit={submit}>
      <fieldset class="whats">
        <legend>{say.what}</legend>
        {whats.map((each) => (
          <label key={each} class={isThere(each) ? "" : "off"}>
            <input
              type="radio"
              name="what"
              checked={what.value === each}
              disabled={!isThere(each)}
              onChange={() => {
                what.value = each;
              }}
            />
            {say.whats[each]}
          </label>
        ))}
      </fieldset>
      {!mesh.value && <p class="quiet about">{say.noMesh}</p>}
      <label class="field">
        {say.format}
        <select
          value={offer?.extension ?? ""}
          onChange={({ currentTarget }) => {
            extension.value = currentTarget.value;
          }}
        >
          {offers.map((each) => (
            <option key={each.extension} value={each.extension}>
              {`.${each.extension} – ${say.formats[each.what === "video" ? "video" : each.extension] ?? each.what}`}
            </option>
          ))}
        </select>
      </label>
      {offer && <ChoiceFields of={offer.choices} chosen={chosen} hasSeveral={isSeveral(what.value)} />}
      <footer>
        <button type="submit" class="main" disabled={!offer}>
          {say.download}
        </button>
      </footer>
    </form>
  );
}

/** Tells whether there is such a thing to be saved. */
function isThere(what: What): boolean {
  switch (what) {
    case "mesh":
    case "cells":
      return mesh.value !== null;
    case "report":
      return mesh.value?.kind === "refine";
    case "run":
      return run.value !== null;
    default:
      return true;
  }
}

/** Tells whether it may become more than one file. */
const isSeveral = (what: What): boolean => what === "mesh" || what === "cells" || what === "drawing";
