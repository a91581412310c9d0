// What a newcomer may try first: four things, each of which is ticked off when it has been done, however.

import { effect, type Signal } from "@preact/signals";
import { openSave } from "../files/dialogs";
import { chooseFiles } from "../files/FileButtons";
import { saved } from "../files/save";
import { source } from "../state/drawing";
import { build, mesh } from "../state/mesh";
import { mode } from "../state/mode";
import { isPlaying, jump, position, run, seek } from "../state/play";
import { kept } from "../state/settings";

export const firstSteps = ["play", "back", "file", "mesh"] as const;
export type FirstStep = (typeof firstSteps)[number];

type State = "open" | "done";
const state = (name: FirstStep): Signal<State> => kept(`first.${name}`, "open", ["open", "done"]);

/** Which have been done, in this visit or one before. */
export const firstStates: Record<FirstStep, Signal<State>> = {
  play: state("play"),
  back: state("back"),
  file: state("file"),
  mesh: state("mesh"),
};

export const isFirstMinuteShown = kept("first", "shown", ["shown", "dismissed"]);

// Whoever comes back and has done everything has seen enough of it.
if (firstSteps.every((step) => firstStates[step].peek() === "done")) isFirstMinuteShown.value = "dismissed";

/** Does a step for somebody. */
export async function doFirst(step: FirstStep): Promise<void> {
  await acts[step]();
}

const acts: Record<FirstStep, () => void | Promise<void>> = {
  play() {
    mode.value = "play";
    isPlaying.value = true;
  },
  async back() {
    mode.value = "play";
    isPlaying.value = false;
    if (position.peek() === 0) seek(run.peek()?.length ?? 0);
    await jump("previous", "flip");
  },
  file: chooseFiles,
  async mesh() {
    mode.value = "mesh";
    if (!mesh.peek()) await build();
    openSave("mesh");
  },
};

function tick(step: FirstStep): void {
  firstStates[step].value = "done";
}

effect(() => {
  if (isPlaying.value) tick("play");
});

// Back is back in the same run; another one begins at its beginning.
let before = { run: run.peek(), position: 0 };
effect(() => {
  const now = { run: run.value, position: position.value };
  if (now.run && now.run === before.run && now.position < before.position) tick("back");
  before = now;
});

effect(() => {
  if (source.value.kind === "files") tick("file");
});

effect(() => {
  if (saved.value === "mesh") tick("mesh");
});
