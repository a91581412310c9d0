// A field for a number. What is being typed stays there, whatever the page comes to know meanwhile.

import { useLayoutEffect, useRef } from "preact/hooks";

interface Props {
  /** What stands there while nobody types; undefined: nothing. */
  value: number | undefined;
  min?: number;
  max?: number;
  step?: string;
  placeholder?: string;
  /** Hears of the field when a number has been typed. */
  onChange: (field: HTMLInputElement) => void;
}

export function NumberInput({ value, onChange, ...rest }: Props) {
  const field = useRef<HTMLInputElement>(null);
  const isTyping = useRef(false);
  const show = () => {
    if (!isTyping.current && field.current) field.current.value = String(value ?? "");
  };
  useLayoutEffect(show, [value]);
  return (
    <input
      {...rest}
      ref={field}
      type="number"
      onInput={() => {
        isTyping.current = true;
      }}
      onChange={({ currentTarget }) => {
        isTyping.current = false;
        onChange(currentTarget);
      }}
      onBlur={() => {
        // Typed, and then typed as it was: nothing has changed, and what has become known meanwhile may be shown.
        if (!isTyping.current) return;
        isTyping.current = false;
        show();
      }}
    />
  );
}
