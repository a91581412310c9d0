// The frame of the page.

import type { Words } from "..";

export const app: Words["app"] = {
  title: "Delone: das Theater",
  modes: { play: "Abspielen", predict: "Vorhersagen", race: "Rennen", mesh: "Vernetzen" },
  modeHints: {
    play: "Einem Algorithmus Schritt für Schritt zusehen",
    predict: "Raten, welche Kante als nächste gekippt wird",
    race: "Mehrere Algorithmen nebeneinander",
    mesh: "Ein Gebiet vernetzen und speichern",
  },
  mode: "Was zu tun ist",
  language: "Sprache",
  theme: "Farben",
  themes: { auto: "wie das System", light: "hell", dark: "dunkel" },
  jobs: {
    draw: "Zeichnen",
    run: "Der Algorithmus läuft",
    mesh: "Vernetzen",
    save: "Schreiben",
    record: "Der Lauf wird aufgenommen",
  },
  cancel: "Abbrechen",
  show: "Zeigen",
  actions: { save: "Speichern …" },
  dismiss: "Schließen",
  skip: "Zur Bühne springen",
  space: "Leertaste",
};
