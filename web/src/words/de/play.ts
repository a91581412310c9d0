// Playing an algorithm.

import type { Words } from "..";

export const play: Words["play"] = {
  heading: "Algorithmus",
  algorithm: "Algorithmus",
  play: "Abspielen",
  pause: "Anhalten",
  next: "Schritt",
  previous: "Schritt zurück",
  first: "Zum Anfang",
  last: "Zum Ende",
  position: "Stelle",
  of: (position, length) => `${position} von ${length}`,
  speed: "Schritte je Sekunde",
  code: "Pseudocode",
  begin: "Vor dem ersten Schritt.",
};
