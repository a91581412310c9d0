// Drawings to begin with.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { stage } from "../engine/client";
import type { Preset, Source } from "../engine/protocol";
import { open, recipe } from "../state/drawing";
import { tell } from "../state/notices";
import { words } from "../words";

type PresetSource = Extract<Source, { kind: "preset" }>;

export function Presets() {
  const presets = useSignal<Preset[]>([]);
  useEffect(() => {
    stage
      .ask((engine) => engine.drawings.presets())
      .then((all) => {
        presets.value = all;
      }, tell);
  }, [presets]);
  const say = words.value.drawing;
  const { source } = recipe.value;
  const now: PresetSource =
    source.kind === "preset" ? source : { kind: "preset", name: "", count: 40, seed: 1 };
  const choose = (change: Partial<PresetSource>) => void open({ ...now, ...change });
  const isSized = presets.value.find(({ name }) => name === now.name)?.sized;
  return (
    <>
      <label class="field">
        {say.preset}
        <select value={now.name} onChange={(event) => choose({ name: event.currentTarget.value })}>
          {(["points", "domain", "scene"] as const).map((kind) => (
            <optgroup key={kind} label={say.kinds[kind]}>
              {presets.value
                .filter((preset) => preset.kind === kind)
                .map(({ name }) => (
                  <option key={name} value={name}>
                    {name}
                  </option>
                ))}
            </optgroup>
          ))}
        </select>
      </label>
      {isSized && (
        <label class="field">
          {say.count}
          <input
            type="number"
            min="3"
            max="2000000"
            value={now.count}
            onChange={(event) => choose({ count: event.currentTarget.valueAsNumber || now.count })}
          />
        </label>
      )}
    </>
  );
}
