// What there is to say of the algorithms. In English the library says it itself.

import type { Words } from "..";

export const algorithms: Words["play"]["algorithms"] = {
  sweep: {
    title: "Plane Sweep, Strecken danach eingefügt",
    idea: "Von links nach rechts wird jeder Punkt mit dem verbunden, was er von der konvexen Front sieht; danach werden die Strecken durch Kippen eingefügt und das Äußere entfernt.",
    cost: "O(n log n), und schlimmstenfalls O(k²) für eine Strecke, die k Kanten kreuzt",
    guarantees: "eine Triangulierung des Gebiets mit allen Strecken; nichts über ihre Winkel",
  },
  "printed-sweep": {
    title: "Plane Sweep wie gedruckt, Strecken im Sichtbarkeitstest",
    idea: "Von links nach rechts wird jeder Punkt mit den Ecken der Front verbunden, die er an den Strecken vorbei sieht.",
    cost: "schlimmstenfalls O(n³): Jeder Sichtbarkeitstest sieht alle Kanten und Punkte an",
    guarantees: "keine: Strecken können verloren gehen, die Hülle hat Dellen; Fehler werden aufgezählt",
  },
  "edge-flip": {
    title: "Kantenkippen von markierten Kanten aus",
    idea: "Jede Kante kann falsch sein. Ist sie es, wird sie gekippt, und die vier Kanten um sie werden wieder angesehen.",
    cost: "schlimmstenfalls O(n²) Kippungen zu je O(log n); bei gutem Anfang weit weniger",
    guarantees: "die kanonische Delaunay-Triangulierung, auch mit festen Kanten",
  },
  thesis: {
    title: "Verfeinerung durch Halbieren und Umkreismittelpunkte",
    idea: "Strecken werden gleichmäßig geteilt, zu lange Kanten halbiert, dann wird wieder und wieder das spitzeste Dreieck geöffnet; nach jedem Schritt wird gekippt.",
    cost: "O(log n) für jede neue Ecke und jede geprüfte Kante; wie viele, entscheiden die Ziele",
    guarantees: "ein Delaunay-Netz mit festen Kanten, keine länger als h; kein Winkel",
  },
  "segment-walk": {
    title: "Inkrementell, mit einem Weg entlang der Strecke",
    idea: "Vom letzten Punkt führt der Weg geradeaus zum nächsten; die Dreiecke um ihn werden geöffnet, und er wird mit dem Rand verbunden.",
    cost: "gewöhnlich O(n√n), schlimmstenfalls O(n²)",
    guarantees: "nach jedem Punkt die kanonische Delaunay-Triangulierung",
  },
  "greedy-flips": {
    title: "Gieriges Kippen",
    idea: "Gleich welche Triangulierung: Solange eine Kante nicht lokal Delaunay ist, wird eine solche gekippt.",
    cost: "O(n³): bis zu n(n−1)/2 Kippungen, und eine Suche in O(n) für jede",
    guarantees: "die kanonische Delaunay-Triangulierung, auch mit festen Kanten",
  },
  "flip-list": {
    title: "Gieriges Kippen mit Arbeitsliste",
    idea: "Kanten, die nicht lokal Delaunay sein könnten, stehen auf einer Liste; eine Kippung fügt ihre vier Nachbarinnen an.",
    cost: "O(n²): bis zu n(n−1)/2 Kippungen mit je vier Tests",
    guarantees: "die kanonische Delaunay-Triangulierung, auch mit festen Kanten",
  },
  incremental: {
    title: "Inkrementelle Konstruktion",
    idea: "Jeder Punkt wird mit dem verbunden, was er sieht; dann werden Kanten gekippt, bis alle wieder lokal Delaunay sind.",
    cost: "schlimmstenfalls O(n²): eine Suche kostet O(n), und so auch die Kippungen für einen Punkt",
    guarantees: "nach jedem Punkt die kanonische Delaunay-Triangulierung",
  },
  "random-incremental": {
    title: "Inkrementell in zufälliger Reihenfolge",
    idea: "Zuerst werden die Punkte gemischt: In zufälliger Reihenfolge sind wenige Kanten zu kippen.",
    cost: "O(n) Kippungen zu erwarten, gleich welche Punkte; O(n²) mit der Suche der Flächen",
    guarantees: "nach jedem Punkt die kanonische Delaunay-Triangulierung",
  },
  "convex-hull": {
    title: "Konvexe Hülle aus zwei Ketten",
    idea: "Was über der Geraden vom linkesten zum rechtesten Punkt liegt, wird von rechts nach links sortiert, was darunter liegt von links nach rechts; beides wird verbunden, Dellen fallen weg.",
    cost: "O(n log n)",
    guarantees:
      "alle Punkte auf dem Rand der Hülle, gegen den Uhrzeigersinn vom rechtesten an; keine Dreiecke",
  },
  "cline-renka": {
    title: "Cline–Renka",
    idea: "Punkt für Punkt, nur mit Listen von Nachbarn: um die erste Ecke drehen, bis der neue Punkt zwischen zwei Nachbarn liegt, zu ihm gehen, ihn verbinden, Kanten um ihn tauschen.",
    cost: "schlimmstenfalls O(n²); ein Weg beginnt immer bei der ersten Ecke, etwa √n Dreiecke entfernt",
    guarantees: "nach jedem Punkt die kanonische Delaunay-Triangulierung",
  },
  "algorithm-a": {
    title: "Algorithmus A: Cluster in einem äußeren Polygon",
    idea: "Um die Daten wird ein Polygon gelegt, und Mittelpunkte von Clustern kommen einzeln hinzu, solange jedes Dreieck der Delaunay-Triangulierung genug Daten enthält; geht keiner, hat das nächste Polygon eine Ecke weniger.",
    cost: "gewöhnlich O(n log n)",
    guarantees: "jedes Datum in einem Dreieck, mindestens d in jedem; keine Schranke nach oben",
  },
  "algorithm-b": {
    title: "Algorithmus B: Ecken auf Kanten",
    idea: "Die Dreiecke kommen an die Reihe, das vollste zuerst: Durch Halbieren wird auf einer Kante oder der anderen Diagonale ein Punkt gesucht, der Dreiecke mit je genug Daten macht; dann wird um ihn für größere Winkel gekippt.",
    cost: "gewöhnlich O(n log n)",
    guarantees: "wie zuvor mindestens d Daten in jedem Dreieck; gewöhnlich selten 3d oder mehr",
  },
  "algorithm-c": {
    title: "Algorithmus C: Ecken in Dreiecken",
    idea: "Jedes Dreieck mit 3d Daten oder mehr wird durch einen Punkt im Inneren geöffnet, der in jedem der drei Teile d übrig lässt.",
    cost: "gewöhnlich O(n log n)",
    guarantees:
      "d bis 3d − 1 Daten in jedem Dreieck, außer wo viele auf einer oder zwei seiner Kanten liegen",
  },
  "bowyer-watson": {
    title: "Bowyer–Watson",
    idea: "Ein Punkt zerstört die Dreiecke, in deren Kreisen er liegt. Sie bilden ein sternförmiges Loch; wird der Punkt mit dessen Rand verbunden, ist alles auf einmal wieder gut.",
    cost: "schlimmstenfalls O(n²); in zufälliger Reihenfolge und mit guter Suche sind O(n log n) zu erwarten",
    guarantees: "nach jedem Punkt die kanonische Delaunay-Triangulierung",
  },
  "sweep-circle": {
    title: "Sweep mit einem Kreis",
    idea: "Ein Kreis wächst von der Mitte aus; jeder Punkt, den er erreicht, liegt außerhalb der bisherigen Hülle und wird mit allen Kanten verbunden, die er sieht; dann wird gekippt.",
    cost: "O(n log n) für das Sortieren; O(n) Kippungen bei gleichmäßig verteilten Punkten, schlimmstenfalls O(n²)",
    guarantees: "nach jedem Punkt die kanonische Delaunay-Triangulierung",
  },
  fortune: {
    title: "Fortunes Sweep",
    idea: "Eine Gerade fegt abwärts durch die Ebene; wo Punkte ihr so nah sind wie der nächsten Stelle, ist eine Front aus Parabeln, deren Bögen an Stellen erscheinen und enden, wo drei auf einem leeren Kreis liegen.",
    cost: "O(n log n) zu erwarten; wo k Punkte einen leeren Kreis teilen, dazu bis zu O(k²) Kippungen",
    guarantees:
      "die Delaunay-Triangulierung, kanonisch gemacht durch Kippen, wo vier Punkte auf einem Kreis liegen",
  },
  "divide-and-conquer": {
    title: "Teile und herrsche",
    idea: "Die Punkte werden in zwei Hälften geschnitten, beide trianguliert und die Triangulierungen von der unteren gemeinsamen Tangente aufwärts verstrickt.",
    cost: "gewöhnlich linear, entlang einer raumfüllenden Kurve; schlimmstenfalls O(n²)",
    guarantees: "die kanonische Delaunay-Triangulierung",
  },
  constrained: {
    title: "Delaunay-Triangulierung mit festen Kanten",
    idea: "Der Korridor von Dreiecken, durch den eine Strecke läuft, wird geräumt und die Strecke zur Kante; beide Seiten werden durch Abschneiden von Ohren trianguliert, und was nicht Delaunay ist, wird gekippt. Zuletzt flutet das Äußere herein bis an die Strecken.",
    cost: "in der Praxis wenige Tests für jede Kante, die eine Strecke kreuzt; O(k log k) für k davon entlang von Kurven",
    guarantees: "die kanonische Delaunay-Triangulierung des Gebiets mit festen Kanten",
  },
  refinement: {
    title: "Delaunay-Verfeinerung",
    idea: "In den leeren Kreis eines schlechten Dreiecks kommt eine Ecke; wo sie aber einer Strecke zu nahe käme, wird stattdessen diese geteilt.",
    cost: "in der Praxis konstant für jede neue Ecke; wie viele es werden, entscheiden die Ziele",
    guarantees:
      "endet bei jeder Eingabe und jedem Winkel, mit einem Delaunay-Netz mit festen Kanten; in der Praxis bis 33°, außer bei Winkeln der Eingabe",
  },
};
