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
  themes: { auto: "Systemfarben", light: "Hell", dark: "Dunkel" },
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
  menu: "Menü",
  guide: "Führer",
  help: "Hilfe",
  left: "Zeichnung und Ansicht",
  right: "Was damit geschieht",
  panels: "Bedienfelder",
  works: { play: "Algorithmus", predict: "Spiel", race: "Rennen", mesh: "Netz" },
  loading: {
    now: "Das Modul wird geladen …",
    failed: "Die Seite kann nicht rechnen",
    reasons: {
      wasm: "Dieser Browser hat kein WebAssembly, oder eine Regel verbietet es hier (manche Schutzmodi tun das). Bitte für diese Seite erlauben, oder einen anderen Browser ab 2023 nehmen.",
      workers: "Dieser Browser hat keine Worker. Bitte einen anderen ab 2023 nehmen.",
      start:
        "Das Modul ließ sich nicht starten. Vielleicht brach die Verbindung ab: dann hilft erneutes Laden. Vielleicht blockiert eine Erweiterung WebAssembly: dann bitte hier erlauben. Browser ab 2023 genügen.",
    },
    again: "Neu laden",
  },
  space: "Leertaste",
};
