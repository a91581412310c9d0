// Coordinates as text.

import { useSignal } from "@preact/signals";
import { words } from "../words";
import { Dialog } from "./Dialog";
import { dialog } from "./dialogs";
import { openText } from "./open";

export function PasteDialog() {
  const say = words.value.files;
  const text = useSignal("");
  const submit = async (event: Event) => {
    event.preventDefault();
    const is = text.value;
    dialog.value = null;
    await openText(is);
  };
  return (
    <Dialog name="paste" heading={say.pasteHeading}>
      <form onSubmit={submit}>
        <label class="field">
          {say.pasteHint}
          <textarea
            rows={8}
            spellcheck={false}
            placeholder={"0 0\n4 0\n4 3\n0 3"}
            value={text.value}
            onInput={({ currentTarget }) => {
              text.value = currentTarget.value;
            }}
          />
        </label>
        <footer>
          <button type="submit" class="main" disabled={text.value.trim() === ""}>
            {say.openText}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}
