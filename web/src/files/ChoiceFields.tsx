// What may be chosen for a file.

import type { Signal } from "@preact/signals";
import { words } from "../words";
import type { Choice } from "./choices";
import type { Chosen } from "./save";

interface Props {
  of: Choice[];
  chosen: Signal<Chosen>;
  /** Whether it may become more than one file. */
  hasSeveral: boolean;
}

const numbers = {
  size: { least: 64, most: 8192 },
  seconds: { least: 1, most: 120 },
  frames: { least: 2, most: 100 },
};

export function ChoiceFields({ of, chosen, hasSeveral }: Props) {
  const choices: (Choice | "zip")[] = hasSeveral ? [...of, "zip"] : of;
  return (
    <div class="choices">
      {choices.map((choice) =>
        choice === "size" || choice === "seconds" || choice === "frames" ? (
          <Measure key={choice} name={choice} chosen={chosen} />
        ) : (
          <label key={choice}>
            <input
              type="checkbox"
              checked={chosen.value[choice]}
              onChange={({ currentTarget }) => {
                chosen.value = { ...chosen.value, [choice]: currentTarget.checked };
              }}
            />
            {words.value.files.choices[choice]}
          </label>
        ),
      )}
    </div>
  );
}

function Measure({ name, chosen }: { name: keyof typeof numbers; chosen: Signal<Chosen> }) {
  const { least, most } = numbers[name];
  return (
    <label>
      {words.value.files.choices[name]}
      <input
        type="number"
        required
        min={least}
        max={most}
        step={1}
        value={chosen.value[name]}
        onInput={({ currentTarget }) => {
          const value = currentTarget.valueAsNumber;
          if (value >= least && value <= most) chosen.value = { ...chosen.value, [name]: value };
        }}
      />
    </label>
  );
}
