// Which algorithm is run, what there is to say of it, and what it wants to know.

import type { Algorithm } from "../engine/protocol";
import { algorithm, algorithms, chosen } from "../state/play";
import { words } from "../words";
import { AlgorithmOptions } from "./AlgorithmOptions";

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
            {titled(title)}
          </option>
        ))}
    </optgroup>
  ));
}

/** Writes a title as the beginning of a line. */
export const titled = (title: string): string => title.charAt(0).toUpperCase() + title.slice(1);

function About({ of }: { of: Algorithm }) {
  const say = words.value.play;
  return (
    <details class="fold">
      <summary>{say.about}</summary>
      {/* What the library says of its algorithms is English. */}
      <dl class="about" lang="en">
        {(["idea", "cost", "guarantees", "source"] as const).map((part) => (
          <div key={part}>
            <dt>{say[part]}</dt>
            <dd>{of[part]}</dd>
          </div>
        ))}
      </dl>
      <a href={`guide/${of.name}.html`} target="_blank" rel="noopener">
        {say.guide}
      </a>
    </details>
  );
}
