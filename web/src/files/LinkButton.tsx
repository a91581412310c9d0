// The link to the page as it is now, for the clipboard.

import { copy } from "../app/clipboard";
import { LinkIcon } from "../app/icons";
import { linkNow } from "../state/link";
import { notify } from "../state/notices";
import { words } from "../words";
import { dialog } from "./dialogs";

export function LinkButton() {
  const say = words.value.files;
  return (
    <button type="button" class="plain" title={say.link} onClick={() => void take()}>
      <LinkIcon />
      <span>{say.link}</span>
    </button>
  );
}

async function take(): Promise<void> {
  const say = words.peek().files;
  const link = await linkNow();
  if (link === null) return notify("info", say.linkTooLarge, { action: { name: "save", run: openSave } });
  const isCopied = await copy(link, () => notify("info", say.linkShown(link)));
  if (isCopied) notify("info", say.linkCopied);
}

function openSave(): void {
  dialog.value = "save";
}
