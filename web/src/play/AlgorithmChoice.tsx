// Which algorithm is run, what there is to say of it, and what it wants to know.

import { computed } from "@preact/signals";
import type { Algorithm } from "../engine/protocol";
import { drawing } from "../state/drawing";
import { algorithm, algorithms, chosen } from "../state/play";
import { words } from "../words";
import { AlgorithmOptions } from "./AlgorithmOptions";
import { described, titleOf } from "./described";

/** Whether the drawing has more than the algorithm looks at. */
const isLeftAside = computed(() => {
  const [takes, about] = [algorithm.value?.takes, drawing.value?.about];
  return (takes === "points" || takes === "data") && about !== undefined && about.segments + about.holes > 0;
});

export function AlgorithmChoice() {
  const say = words.value.play;
  return (
    <section aria-labelledby="play-heading">
      <h2 id="play-heading">{say.heading}</h2>
      <select
        class="wide"
        aria-labelledby="play-heading"
        value={chosen.value}
        onChange={(event) => {
          chosen.value = event.currentTarget.value;
        }}
      >
        <AlgorithmList />
      </select>
      {isLeftAside.value && <p class="quiet aside">{say.leftAside}</p>}
      {algorithm.value && <About of={algorithm.value} />}
      <AlgorithmOptions />
    </section>
  );
}

const groups: Algorithm["takes"][] = ["points", "triangulation", "domain", "data"];

/** The algorithms, as options of a select, by what they take. */
export function AlgorithmList() {
  const say = words.value.play;
  return groups.map((takes) => (
    <optgroup key={takes} label={say.takes[takes]}>
      {algorithms.value
        .filter((each) => each.takes === takes)
        .map(({ name, title }) => (
          <option key={name} value={name}>
            {titleOf(name, title)}
          </option>
        ))}
    </optgroup>
  ));
}

function About({ of }: { of: Algorithm }) {
  const say = words.value.play;
  const told = described(of);
  return (
    <details class="fold">
      <summary>{say.about}</summary>
      <dl class="about" lang={told.isEnglish ? "en" : undefined}>
        {(["idea", "cost", "guarantees"] as const).map((part) => (
          <div key={part}>
            <dt>{say[part]}</dt>
            <dd>{told[part]}</dd>
          </div>
        ))}
        <dt>{say.source}</dt>
        <dd lang="en">{of.source}</dd>
      </dl>
      <a href={`guide/${of.name}.html`} target="_blank" rel="noopener">
        {say.guide}
      </a>
    </details>
  );
}
