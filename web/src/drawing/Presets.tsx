// Drawings to begin with.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { DiceIcon } from "../app/icons";
import { NumberInput } from "../app/NumberInput";
import { stage } from "../engine/client";
import type { Preset, Source } from "../engine/protocol";
import { open, source } from "../state/drawing";
import { tell } from "../state/notices";
import { words } from "../words";
import { boundsOf, within } from "./bounds";

type PresetSource = Extract<Source, { kind: "preset" }>;

/** Seeds that the dice throws: few digits, to be told to others. */
const SEEDS = 10_000;

const kinds = ["points", "domain", "scene"] as const;

/** The one that the page opens with is known before the module has come, so that nothing jumps then. */
const first: Preset[] = [{ name: "uniform", about: "", kind: "points", sized: true }];

export function Presets() {
  const presets = useSignal(first);
  useEffect(() => {
    stage
      .insist((engine) => engine.drawings.presets())
      .then((all) => {
        presets.value = all;
      }, tell);
  }, [presets]);
  const say = words.value.drawing;
  const now = source.value.kind === "preset" ? source.value : null;
  const preset = presets.value.find(({ name }) => name === now?.name);
  return (
    <>
      <label class="field">
        {say.preset}
        <select value={now?.name ?? ""} onChange={(event) => begin(presets.value, event.currentTarget.value)}>
          {!now && <option value="">{say.chosen}</option>}
          {kinds.map((kind) => (
            <optgroup key={kind} label={say.kinds[kind]}>
              {presets.value
                .filter((each) => each.kind === kind)
                .map(({ name }) => (
                  <option key={name} value={name}>
                    {say.presets[name]?.[0] ?? name}
                  </option>
                ))}
            </optgroup>
          ))}
        </select>
      </label>
      {preset && <p class="quiet about">{say.presets[preset.name]?.[1] ?? preset.about}</p>}
      {preset?.sized && now && <Size of={preset} now={now} />}
    </>
  );
}

/** Takes a preset, with as many points as suit it. */
function begin(presets: Preset[], name: string): void {
  const preset = presets.find((each) => each.name === name);
  if (!preset) return;
  const now = source.peek();
  const seed = now.kind === "preset" ? now.seed : 1;
  void open({ kind: "preset", name, count: boundsOf(preset).usual, seed });
}

function Size({ of, now }: { of: Preset; now: PresetSource }) {
  const say = words.value.drawing;
  const bounds = boundsOf(of);
  const change = (part: Partial<PresetSource>) => void open({ ...now, ...part });
  return (
    <div class="size">
      <label class="field">
        {say.count[of.kind === "domain" ? "segments" : "points"]}
        <NumberInput
          min={bounds.least}
          max={bounds.most}
          value={now.count}
          onChange={(field) => {
            const count = within(bounds, field.valueAsNumber);
            field.value = String(count);
            change({ count });
          }}
        />
      </label>
      <label class="field">
        {say.seed}
        <NumberInput
          min={0}
          max={0xffffffff}
          value={now.seed}
          onChange={(field) => {
            const seed = Math.min(0xffffffff, Math.max(0, Math.round(field.valueAsNumber || 0)));
            field.value = String(seed);
            change({ seed });
          }}
        />
      </label>
      <button
        type="button"
        class="tool"
        aria-label={say.another}
        title={say.another}
        onClick={() => change({ seed: Math.floor(Math.random() * SEEDS) })}
      >
        <DiceIcon />
      </button>
    </div>
  );
}
