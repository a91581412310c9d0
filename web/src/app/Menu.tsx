// What is not about the drawing: the guide, how the page looks, help. In little room it is folded into a menu.

import { type Signal, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { dialog } from "../files/dialogs";
import { LinkButton } from "../files/LinkButton";
import { words } from "../words";
import { GuideIcon, HelpIcon, MenuIcon } from "./icons";
import { Looks } from "./Looks";

export function Menu() {
  const say = words.value.app;
  const isOpen = useSignal(false);
  const whole = useRef<HTMLDivElement>(null);
  useEffect(() => closing(whole.current!, isOpen), [isOpen]);
  return (
    <div class="menu" ref={whole}>
      <button
        type="button"
        class="icon-button menu-button"
        aria-label={say.menu}
        aria-expanded={isOpen.value}
        aria-controls="menu"
        onClick={() => {
          isOpen.value = !isOpen.value;
        }}
      >
        <MenuIcon />
      </button>
      <div class="menu-items" id="menu" data-open={isOpen.value}>
        <a class="plain" href="./guide/index.html">
          <GuideIcon />
          <span>{say.guide}</span>
        </a>
        <LinkButton />
        <Looks />
        <button
          type="button"
          class="plain"
          title={`${say.help} (?)`}
          onClick={() => {
            isOpen.value = false;
            dialog.value = "help";
          }}
        >
          <HelpIcon />
          <span>{say.help}</span>
        </button>
      </div>
    </div>
  );
}

/** Closes the menu when something else is pressed or gets the focus, or by Escape, until the function is called. */
function closing(whole: HTMLElement, isOpen: Signal<boolean>): () => void {
  const abort = new AbortController();
  const { signal } = abort;
  const closeUnless = (inside: EventTarget | null) => {
    if (inside instanceof Node && !whole.contains(inside)) isOpen.value = false;
  };
  document.addEventListener("pointerdown", ({ target }) => closeUnless(target), { signal });
  whole.addEventListener("focusout", ({ relatedTarget }) => closeUnless(relatedTarget), { signal });
  const leave = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || !isOpen.peek()) return;
    event.stopPropagation();
    isOpen.value = false;
    whole.querySelector("button")?.focus();
  };
  whole.addEventListener("keydown", leave, { signal });
  return () => abort.abort();
}
