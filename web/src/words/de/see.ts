// What can be shown over the stage.

import type { Words } from "..";

export const see: Words["see"] = {
  heading: "Sehen",
  groups: {
    step: "Dieser Schritt",
    structure: "Struktur",
    geometry: "Geometrie",
    pointer: "Unter dem Zeiger",
  },
  names: {
    marks: "Markierungen",
    circle: "Umkreistest",
    walk: "Suchweg",
    waiting: "Stapel oder Schlange",
    front: "Front",
    sweep: "Sweep",
    rays: "Sichtstrahlen",
    encroached: "Bedrängte Strecken",
    clusters: "Gruppen",
    holders: "Daten",
    numbers: "Nummern",
    illegal: "Illegale Kanten",
    cocircular: "Kozirkular",
    voronoi: "Voronoi-Zellen",
    dual: "Dual (Voronoi)",
    circles: "Durchmesserkreise",
    halfEdges: "Halbkanten",
    nearest: "Nächste Ecke",
    triangle: "Dreieck",
  },
  about: {
    marks:
      "Worum es im Schritt geht: Grünes kommt oder darf bleiben, Rotes (gestrichelt, Kreuze) geht oder muss gehen, Gelbes (Ringe) wird betrachtet.",
    circle:
      "Der letzte Umkreistest: Liegt der vierte Punkt innen? Die Antwort ist exakt. Liegt er auf dem Kreis, gilt der am weitesten rechts liegende der vier als etwas angehoben, und das entscheidet.",
    walk: "Die Dreiecke und Kanten, die seit Beginn dieser Runde besucht wurden, in ihrer Reihenfolge, bis aus dem Fund etwas gemacht wird.",
    waiting:
      "Was darauf wartet, betrachtet zu werden, nummeriert in der Reihenfolge der Ankunft. Was zuerst an die Reihe kommt, ist kräftiger gezeichnet.",
    front: "Der Rand dessen, was ein Sweep fertiggestellt hat; bei Fortunes Algorithmus die Uferlinie.",
    sweep: "Die Gerade oder der Kreis, mit dem die Ebene überstrichen wird.",
    rays: "Wer wen sieht: gestrichelt, wo etwas im Weg ist.",
    encroached:
      "Die Strecke, der eine Ecke zu nahe ist, mit ihrem Durchmesserkreis; oder zu nahe wäre, käme sie dahin, wo sie hin soll.",
    clusters: "Die Mittelpunkte der Gruppen von Daten.",
    holders: "Für welches Dreieck jeder Datenpunkt zählt, und wie viele jedes Dreieck hat.",
    numbers: "Die Nummern der Ecken. Sie verblassen, wenn es zu viele sind: näher herangehen.",
    illegal:
      "Kanten, die nicht lokal Delaunay sind: Der Umkreis auf einer Seite enthält die Ecke der anderen.",
    cocircular: "Vierecke, deren vier Ecken exakt auf einem Kreis liegen: Beide Diagonalen wären recht.",
    voronoi:
      "Was jedem Punkt näher liegt als jedem anderen, welche Dreiecke es auch gibt. Von sehr vielen Zellen ist nichts zu sehen: näher heran!",
    dual: "Umkreismittelpunkte benachbarter Dreiecke, verbunden. Wo die Triangulierung Delaunay ist, sind das die Grenzen der Voronoi-Zellen.",
    circles: "Der kleinste Kreis um jede Zwangskante. Rot: Eine benachbarte Ecke liegt darin.",
    halfEdges:
      "Die Halbkante neben dem Zeiger, ihr Zwilling, und die nächsten und vorigen um Dreieck und Anfangspunkt.",
    nearest:
      "Die Ecke, die dem Zeiger am nächsten liegt, und der Weg durch die Dreiecke, auf dem sie gefunden wird.",
    triangle: "Das Dreieck unter dem Zeiger, und ob sein Umkreis leer ist.",
  },
  hint: "Was ein Schalter zeigt, steht hier, sobald der Zeiger darauf ruht.",
  reset: "Wie üblich",
  sides: { inside: "innen", outside: "außen" },
  onCircle: (counts) => `auf dem Kreis: ${counts}`,
  raised: "angehoben",
  circleHolds: (inside, on) =>
    `${inside === 0 ? "leer" : `${inside} innen`}${on === 0 ? "" : `, ${on} auf dem Kreis`}`,
  waiting: {
    heading: "Was wartet",
    queues: {
      suspects: "Verdächtige",
      search: "Suche",
      cavity: "Höhle",
      events: "Ereignisse",
      crossings: "Kreuzungen",
    },
    next: "kommt zuerst",
    more: (count) => `und ${count} weitere`,
    vertex: (v) => `Ecke ${v}`,
    edge: (a, b) => `Kante ${a}–${b}`,
    triangle: (a, b, c) => `Dreieck ${a}, ${b}, ${c}`,
  },
  lift: {
    show: "Angehobene Ansicht",
    about:
      "Jeder Punkt auf die Höhe x² + y² gehoben: Die Delaunay-Dreiecke sind die Facetten der unteren Hülle. Rote Kanten knicken falsch herum.",
    label:
      "Die Triangulierung, auf ein Paraboloid gehoben. Ziehen oder Pfeiltasten drehen sie, Pos1 zeigt sie wieder von der Seite.",
    height: "Höhe",
    flat: "flach",
    lifted: "angehoben",
    close: "Angehobene Ansicht schließen",
    none: "Es gibt noch keine Dreiecke.",
    tooMany: (most) => `Mehr als ${most} Dreiecke werden nicht angehoben.`,
    bent: (count) => (count === 1 ? "1 Kante knickt falsch herum" : `${count} Kanten knicken falsch herum`),
    convex: "konvex: Jede Kante ist lokal Delaunay",
  },
};
