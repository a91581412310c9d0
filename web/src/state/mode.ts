// What the page is used for at the moment.

import { signal } from "@preact/signals";

/** play: watch an algorithm. predict: guess its next flip. race: several beside each other. mesh: get work done. */
export const modes = ["play", "predict", "race", "mesh"] as const;
export type Mode = (typeof modes)[number];

export const mode = signal<Mode>("play");
