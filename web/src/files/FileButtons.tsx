// Buttons that open and save.

import { createRef } from "preact";
import { OpenIcon, PasteIcon, SaveIcon } from "../app/icons";
import { words } from "../words";
import { dialog } from "./dialogs";
import { openFiles } from "./open";

const field = createRef<HTMLInputElement>();

/** Asks which files are to be opened. */
export function chooseFiles(): void {
  field.current?.click();
}

export function FileButtons() {
  const say = words.value.files;
  const show = (name: "save" | "paste") => {
    dialog.value = name;
  };
  return (
    <>
      <button type="button" class="worded" onClick={chooseFiles}>
        <OpenIcon />
        {say.open}
      </button>
      <input
        ref={field}
        type="file"
        multiple
        hidden
        aria-label={say.open}
        onChange={({ currentTarget }) => {
          void openFiles([...(currentTarget.files ?? [])]);
          // The same file may be chosen again.
          currentTarget.value = "";
        }}
      />
      <button type="button" class="worded" onClick={() => show("paste")}>
        <PasteIcon />
        {say.paste}
      </button>
      <button type="button" class="worded" onClick={() => show("save")}>
        <SaveIcon />
        {say.save}
      </button>
    </>
  );
}
