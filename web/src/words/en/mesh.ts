// Meshes: what is asked, and what came of it.

export const mesh = {
  heading: "Mesh",
  kind: "What to build",
  kinds: {
    triangulate: "Delaunay triangulation of the points",
    constrain: "Constrained Delaunay triangulation",
    refine: "Quality mesh",
  },
  minAngle: "Smallest angle, degrees",
  maxEdge: "Longest edge",
  build: "Mesh it",
  triangles: "Triangles",
  vertices: "Vertices",
  hash: "Hash",
};
