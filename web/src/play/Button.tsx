// A button with an icon, its name, and its key in the tooltip.

import type { ComponentChildren } from "preact";

interface ButtonProps {
  label: string;
  keys: string;
  isOff: boolean;
  isMain?: boolean;
  act: () => void;
  children: ComponentChildren;
}

export function Button({ label, keys, isOff, isMain, act, children }: ButtonProps) {
  return (
    <button
      type="button"
      class={isMain ? "tool main" : "tool"}
      aria-label={label}
      title={`${label} (${keys})`}
      // Not `disabled`: the focus stays where it is when the end is reached.
      aria-disabled={isOff}
      onClick={isOff ? undefined : act}
    >
      {children}
    </button>
  );
}
