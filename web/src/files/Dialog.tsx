// A dialog as the browser has it: it keeps the focus, and Escape closes it.

import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { words } from "../words";
import { dialog } from "./dialogs";
import "./files.css";

interface Props {
  name: NonNullable<typeof dialog.value>;
  heading: string;
  children: ComponentChildren;
}

export function Dialog({ name, heading, children }: Props) {
  const element = useRef<HTMLDialogElement>(null);
  const isOpen = dialog.value === name;
  useEffect(() => {
    if (isOpen) element.current?.showModal();
    else element.current?.close();
  }, [isOpen]);
  const close = () => {
    if (dialog.peek() === name) dialog.value = null;
  };
  return (
    <dialog ref={element} class="dialog" aria-labelledby={`${name}-heading`} onClose={close}>
      {isOpen && (
        <>
          <header>
            <h2 id={`${name}-heading`}>{heading}</h2>
            <button type="button" class="close" aria-label={words.value.files.close} onClick={close}>
              ×
            </button>
          </header>
          {children}
        </>
      )}
    </dialog>
  );
}
