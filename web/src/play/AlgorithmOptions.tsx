// What the algorithm wants to know.

import { DiceIcon } from "../app/icons";
import { NumberInput } from "../app/NumberInput";
import type { RunOptions } from "../engine/protocol";
import { algorithm, options } from "../state/play";
import { words } from "../words";
import { usual, wants, withOption } from "./wants";

const rules = ["hull", "carve", "evenodd"] as const;

const limits: Partial<Record<keyof RunOptions, { min: number; max?: number; step?: string }>> = {
  seed: { min: 0, max: 0xffffffff },
  minAngle: { min: 0, max: 40, step: "any" },
  maxEdge: { min: 0, step: "any" },
  dataPerTriangle: { min: 1 },
};

function put(name: keyof RunOptions, value: unknown): void {
  options.value = withOption(options.value, name, value);
}

export function AlgorithmOptions() {
  const all = algorithm.value ? wants(algorithm.value) : [];
  if (all.length === 0) return null;
  return (
    <fieldset class="options" aria-label={words.value.play.options}>
      {all.map((name) => (name === "domain" ? <Rule key={name} /> : <Amount key={name} name={name} />))}
    </fieldset>
  );
}

function Amount({ name }: { name: Exclude<keyof RunOptions, "domain"> }) {
  const say = words.value.play;
  const now = options.value;
  // One bound alone means that there is no other.
  const isAlone = (now.minAngle ?? now.maxEdge) !== undefined;
  return (
    <div class="amount">
      <label class="field">
        {say[name]}
        <NumberInput
          {...limits[name]}
          placeholder={isAlone ? "–" : placeholderOf(name)}
          value={now[name]}
          onChange={(field) => put(name, field.valueAsNumber)}
        />
      </label>
      {name === "seed" && (
        <button type="button" class="tool" aria-label={say.dice} title={say.dice} onClick={roll}>
          <DiceIcon />
        </button>
      )}
    </div>
  );
}

/** An empty field tells what is taken. */
function placeholderOf(name: keyof RunOptions): string {
  const known = algorithm.value && usual(algorithm.value, name);
  return known ?? (name === "maxEdge" ? "–" : words.value.play.usual);
}

function roll(): void {
  put("seed", Math.floor(Math.random() * 10_000));
}

function Rule() {
  const say = words.value.play;
  return (
    <label class="field">
      {say.domain}
      <select
        value={options.value.domain ?? ""}
        onChange={(event) => put("domain", event.currentTarget.value)}
      >
        <option value="">{say.rules.usual}</option>
        {rules.map((rule) => (
          <option key={rule} value={rule}>
            {say.rules[rule]}
          </option>
        ))}
      </select>
    </label>
  );
}
