// A dialog as the browser has it: it keeps the focus, and Escape closes it.

import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { CloseIcon } from "../app/icons";
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
    <dialog ref={element} class={`dialog dialog-${name}`} aria-labelledby={`${name}-heading`} onClose={close}>
      {isOpen && (
        <>
          <header>
            <h2 id={`${name}-heading`}>{heading}</h2>
            <button type="button" class="icon-button" aria-label={words.value.files.close} onClick={close}>
              <CloseIcon />
            </button>
          </header>
          {children}
        </>
      )}
    </dialog>
  );
}
