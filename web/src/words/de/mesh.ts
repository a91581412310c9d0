// Meshes: what is asked, and what came of it.

import type { Words } from "..";

export const mesh: Words["mesh"] = {
  heading: "Netz",
  kind: "Was gebaut wird",
  kinds: {
    triangulate: "Delaunay-Triangulierung der Punkte",
    constrain: "Delaunay-Triangulierung mit festen Kanten",
    refine: "Gutes Netz",
  },
  minAngle: "Kleinster Winkel, Grad",
  maxEdge: "Längste Kante",
  build: "Vernetzen",
  triangles: "Dreiecke",
  vertices: "Ecken",
  hash: "Prüfsumme",
};
