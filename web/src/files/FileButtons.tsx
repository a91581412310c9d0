// Buttons that open and save.

import { useRef } from "preact/hooks";
import { OpenIcon, PasteIcon, SaveIcon } from "../app/icons";
import { words } from "../words";
import { dialog } from "./dialogs";
import { openFiles } from "./open";

export function FileButtons() {
  const say = words.value.files;
  const field = useRef<HTMLInputElement>(null);
  const show = (name: "save" | "paste") => {
    dialog.value = name;
  };
  return (
    <>
      <button type="button" class="worded" onClick={() => field.current?.click()}>
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
