// Guessing the next flip.

import type { Words } from "..";

export const predict: Words["predict"] = {
  heading: "Die nächste Kippung vorhersagen",
  rules:
    "Der Algorithmus steht vor einer Kippung. Welche Kante wird es sein? Zu achten ist auf Kreise, die nicht leer sind, und auf die Reihenfolge, in der der Algorithmus vorgeht.",
  difficulty: "Welche Kanten",
  difficulties: { three: "eine von dreien", all: "jede Kante" },
  ask: {
    three: "Welche der drei wird als nächste gekippt? Anklicken, oder Taste 1, 2 oder 3.",
    all: "Welche Kante wird als nächste gekippt? Anklicken, oder mit den Pfeiltasten und der Eingabetaste wählen.",
  },
  loading: "Die nächste Kippung wird gesucht …",
  bar: "Die Frage",
  choices: "Kanten zur Auswahl",
  hint: "Hinweis",
  hintHint: "Die Kanten zeigen, die nicht lokal Delaunay sind",
  next: "Nächstes Rätsel",
  skip: "Ein anderes",
  again: "Von vorn",
  over: "Keine Kippung ist übrig.",
  noFlips: "Dieser Algorithmus kippt hier keine Kanten. Einer von diesen tut es:",
  score: "Punktestand",
  right: "richtig",
  streak: "in Folge",
  best: "längste Folge",
  verdicts: {
    right: "Richtig!",
    almost: "Fast: Auch diese Kante muss weichen, aber noch nicht.",
    wrong: "Nein.",
  },
  flipped: (edge, made) => `Kante ${edge} wird zu ${made} gekippt`,
  inside: (edge, v, c) =>
    `: Ecke ${v} liegt im Kreis durch ${edge} und ${c}, also ist die Kante nicht lokal Delaunay.`,
  onInside: (edge, v, c) =>
    `: Ecke ${v} liegt genau auf dem Kreis durch ${edge} und ${c}; der Gleichstand zählt als innen.`,
  decided: (test) => `. ${test} Das entscheidet hier, nicht der Kreis.`,
  stays: (edge, v, c) =>
    `Kante ${edge} ist lokal Delaunay: Ecke ${v} liegt außerhalb des Kreises durch sie und ${c}.`,
  staysOn: (edge, v, c) =>
    `Kante ${edge} darf bleiben: Ecke ${v} liegt genau auf dem Kreis durch sie und ${c}, und der Gleichstand zählt als außen.`,
};
