// Fields of the panel: each with a sentence that says what it means.

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { number, words } from "../words";
import { readNumber } from "./numbers";

/** What a number has to be; both ends may be taken. */
export interface Range {
  low?: number;
  high?: number;
  /** Whether it must be more than 0. */
  isPositive?: boolean;
  isWhole?: boolean;
}

interface NumberProps extends Range {
  label: string;
  hint?: string | undefined;
  value: number | undefined;
  /** What an empty field means; if missing, it must not be empty. */
  empty?: string;
  /** A value to be taken by a click. */
  suggestion?: number;
  isLabelHidden?: boolean;
  onChange: (value: number | undefined) => void;
}

/** A number; what is none, or out of range, is refused and stays to be corrected. */
export function NumberField(props: NumberProps) {
  const { label, hint, value, empty, suggestion, isLabelHidden, onChange } = props;
  const id = useId();
  const say = words.value.mesh;
  // What is being written, as long as it is not taken.
  const draft = useSignal<string | null>(null);
  const text = draft.value ?? (value === undefined ? "" : String(value));
  const wrong = draft.value === null ? null : complaint(draft.value, props);
  const write = (next: string) => {
    draft.value = next;
    if (complaint(next, props) !== null) return;
    onChange(next.trim() === "" ? undefined : readNumber(next)!);
  };
  return (
    <div class="field">
      <label for={id} class={isLabelHidden ? "hidden" : ""}>
        {label}
      </label>
      <span class="mesh-number">
        <input
          id={id}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          value={text}
          placeholder={empty}
          aria-invalid={wrong !== null}
          aria-describedby={`${id}-hint`}
          onInput={({ currentTarget }) => write(currentTarget.value)}
          onBlur={() => {
            if (wrong === null) draft.value = null;
          }}
        />
        {suggestion !== undefined && suggestion !== value && (
          <button type="button" onClick={() => write(String(suggestion))}>
            {say.suggest(number(suggestion))}
          </button>
        )}
      </span>
      <small
        id={`${id}-hint`}
        class={wrong === null ? "quiet" : "mesh-wrong"}
        role={wrong ? "alert" : undefined}
      >
        {wrong ?? hint}
      </small>
    </div>
  );
}

/** Says what is wrong with what is written; null: nothing. */
function complaint(text: string, { empty, low, high, isPositive, isWhole }: NumberProps): string | null {
  const say = words.value.mesh.wrong;
  if (text.trim() === "" && empty !== undefined) return null;
  const value = readNumber(text);
  if (value === null) return say.number;
  if (isPositive && value <= 0) return say.positive;
  if (isWhole && !Number.isInteger(value)) return say.whole;
  const [least, most] = [low ?? Number.NEGATIVE_INFINITY, high ?? Number.POSITIVE_INFINITY];
  return value < least || value > most ? say.range(number(least), number(most)) : null;
}

interface CheckProps {
  label: string;
  hint?: string;
  isOn: boolean;
  onChange: (isOn: boolean) => void;
}

export function Check({ label, hint, isOn, onChange }: CheckProps) {
  const id = useId();
  return (
    <div class="mesh-check">
      <label>
        <input
          type="checkbox"
          checked={isOn}
          aria-describedby={id}
          onChange={({ currentTarget }) => onChange(currentTarget.checked)}
        />
        {label}
      </label>
      <small id={id} class="quiet">
        {hint}
      </small>
    </div>
  );
}

interface ChoiceProps<T extends string> {
  label: string;
  hint?: string;
  value: T;
  options: readonly (readonly [T, string])[];
  onChange: (value: T) => void;
  children?: ComponentChildren;
}

export function Choice<T extends string>({ label, hint, value, options, onChange }: ChoiceProps<T>) {
  const id = useId();
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <select
        id={id}
        value={value}
        aria-describedby={`${id}-hint`}
        onChange={({ currentTarget }) => onChange(currentTarget.value as T)}
      >
        {options.map(([name, text]) => (
          <option key={name} value={name}>
            {text}
          </option>
        ))}
      </select>
      {hint && (
        <small id={`${id}-hint`} class="quiet">
          {hint}
        </small>
      )}
    </div>
  );
}
