// Files that are dropped, or pasted, anywhere on the page.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { notify } from "../state/notices";
import { words } from "../words";
import { openFiles, openText } from "./open";
import "./files.css";

export function DropZone() {
  const isOver = useSignal(false);
  useEffect(() => {
    const abort = new AbortController();
    const on = <Name extends keyof DocumentEventMap>(
      name: Name,
      listener: (event: DocumentEventMap[Name]) => void,
    ) => document.addEventListener(name, listener, { signal: abort.signal });
    on("dragover", (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      isOver.value = true;
    });
    on("dragleave", (event) => {
      if (event.relatedTarget === null) isOver.value = false;
    });
    on("drop", (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      isOver.value = false;
      void openFiles(event.dataTransfer.files);
    });
    on("paste", paste);
    return () => abort.abort();
  }, [isOver]);
  return isOver.value ? (
    <div class="drop" aria-hidden="true">
      <p>{words.value.files.dropHere}</p>
    </div>
  ) : null;
}

function paste(event: ClipboardEvent): void {
  const { target, clipboardData } = event;
  if (!clipboardData || (target instanceof HTMLElement && target.matches("input, textarea, dialog *")))
    return;
  const text = clipboardData.getData("text/plain");
  if (clipboardData.files.length > 0) void openFiles(clipboardData.files);
  else if (/\d/.test(text)) void openText(text);
  else if (text.trim() !== "") notify("info", words.peek().files.noCoordinates);
}
