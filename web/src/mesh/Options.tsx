// What is asked of a mesh.

import { useId } from "preact/hooks";
import type { MeshKind, MeshOptions, Rule } from "../engine/protocol";
import { drawing } from "../state/drawing";
import { kind, options } from "../state/mesh";
import { words } from "../words";
import { Expected } from "./Expected";
import { USUAL_LIMIT } from "./estimate";
import { Check, Choice, NumberField } from "./fields";
import { follows } from "./follow";
import { suggested } from "./sizes";

const kinds: MeshKind[] = ["triangulate", "constrain", "refine"];
const rules: Rule[] = ["hull", "carve", "evenodd"];

/** Angles beyond which refinement need not end by itself, and the largest that may be asked for. */
const MUCH = 33;
const MOST = 35;

/** More passes change nothing that can be seen. */
const MOST_PASSES = 100;

/** More fill the memory of a page. */
const MOST_VERTICES = 5_000_000;

export function Options() {
  const isDomain = kind.value !== "triangulate";
  const isRefined = kind.value === "refine";
  return (
    <>
      <Kinds />
      {isRefined && <Angle />}
      {isRefined && <Sizes />}
      <Expected />
      {isDomain && <Domain />}
      {isRefined && <More />}
      {follows.value && <p class="quiet mesh-small">{words.value.mesh.follows}</p>}
    </>
  );
}

/** Asks for something else; what is `undefined` is not asked for. */
function ask(change: { [Name in keyof MeshOptions]: MeshOptions[Name] | undefined }): void {
  const next = Object.entries({ ...options.peek(), ...change }).filter(([, value]) => value !== undefined);
  options.value = Object.fromEntries(next);
}

function Kinds() {
  const say = words.value.mesh;
  return (
    <fieldset class="mesh-kinds">
      <legend>{say.kind}</legend>
      {kinds.map((each) => (
        <label key={each} class="mesh-kind">
          <input
            type="radio"
            name="mesh-kind"
            checked={kind.value === each}
            onChange={() => {
              kind.value = each;
            }}
          />
          <span>
            {say.kinds[each]}
            <small class="quiet">{say.kindHints[each]}</small>
          </span>
        </label>
      ))}
    </fieldset>
  );
}

function Angle() {
  const id = useId();
  const say = words.value.mesh;
  const { minAngle = 0 } = options.value;
  return (
    <div class="mesh-angle">
      <label for={id}>{say.minAngle}</label>
      <span class="mesh-slider">
        <input
          id={id}
          type="range"
          min="0"
          max={MOST}
          step="0.5"
          value={minAngle}
          aria-valuetext={`${minAngle}°`}
          onInput={({ currentTarget }) => ask({ minAngle: currentTarget.valueAsNumber })}
        />
        <NumberField
          label={say.minAngleValue}
          isLabelHidden
          value={minAngle}
          low={0}
          high={MOST}
          onChange={(value) => ask({ minAngle: value })}
        />
        <span aria-hidden="true">°</span>
      </span>
      <small class={minAngle > MUCH ? "mesh-warning" : "quiet"}>
        {minAngle > MUCH ? say.minAngleMuch : say.minAngleHint}
      </small>
    </div>
  );
}

function Sizes() {
  const say = words.value.mesh;
  const { maxEdge, maxArea, regionAreas = false, thesis } = options.value;
  return (
    <>
      <NumberField
        label={say.maxEdge}
        hint={say.maxEdgeHint}
        value={maxEdge}
        empty={say.none}
        suggestion={suggested.value.maxEdge}
        isPositive
        onChange={(value) => ask({ maxEdge: value })}
      />
      <fieldset class="mesh-plain" disabled={thesis}>
        <NumberField
          label={say.maxArea}
          hint={say.maxAreaHint}
          value={maxArea}
          empty={say.none}
          suggestion={suggested.value.maxArea}
          isPositive
          onChange={(value) => ask({ maxArea: value })}
        />
        {(drawing.value?.about.regions ?? 0) > 0 && (
          <Check
            label={say.regionAreas}
            hint={say.regionAreasHint}
            isOn={regionAreas}
            onChange={(isOn) => ask({ regionAreas: isOn || undefined })}
          />
        )}
      </fieldset>
    </>
  );
}

function Domain() {
  const say = words.value.mesh;
  const { domain, crossings = "error" } = options.value;
  const usual = drawing.value?.about.rule ?? "hull";
  return (
    <>
      <Choice
        label={say.rule}
        hint={say.ruleHint}
        value={domain ?? "usual"}
        options={[
          ["usual", say.rules.usual(say.rules[usual])],
          ...rules.map((rule) => [rule, say.rules[rule]] as const),
        ]}
        onChange={(rule: Rule | "usual") => ask({ domain: rule === "usual" ? undefined : rule })}
      />
      <Choice
        label={say.crossings}
        hint={say.crossingsHint}
        value={crossings}
        options={[
          ["error", say.crossingRules.error],
          ["split", say.crossingRules.split],
        ]}
        onChange={(rule) => ask({ crossings: rule === "split" ? rule : undefined })}
      />
    </>
  );
}

function More() {
  const say = words.value.mesh;
  const { smoothing = 0, conforming = false, thesis = false, maxVertices = USUAL_LIMIT } = options.value;
  return (
    <details>
      <summary>{say.more}</summary>
      <NumberField
        label={say.maxVertices}
        hint={say.maxVerticesHint}
        value={maxVertices}
        low={3}
        high={MOST_VERTICES}
        isWhole
        onChange={(value) => ask({ maxVertices: value === USUAL_LIMIT ? undefined : value })}
      />
      <fieldset class="mesh-plain" disabled={thesis}>
        <NumberField
          label={say.smoothing}
          hint={say.smoothingHint}
          value={smoothing}
          low={0}
          high={MOST_PASSES}
          isWhole
          onChange={(value) => ask({ smoothing: value || undefined })}
        />
        <Check
          label={say.conforming}
          hint={say.conformingHint}
          isOn={conforming}
          onChange={(isOn) => ask({ conforming: isOn || undefined })}
        />
      </fieldset>
      <Check
        label={say.thesis}
        hint={say.thesisHint}
        isOn={thesis}
        onChange={(isOn) => ask({ thesis: isOn || undefined })}
      />
    </details>
  );
}
