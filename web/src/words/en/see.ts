// What can be shown over the stage.

export const see = {
  heading: "See",
  groups: { step: "This step", structure: "Structure", geometry: "Geometry", pointer: "Under the pointer" },
  names: {
    marks: "Marks",
    circle: "Circle test",
    walk: "Walk",
    waiting: "Stack or queue",
    front: "Front",
    sweep: "Sweep",
    rays: "Rays",
    encroached: "Encroachment",
    clusters: "Clusters",
    holders: "Data",
    numbers: "Numbers",
    illegal: "Illegal edges",
    cocircular: "Cocircular",
    voronoi: "Voronoi cells",
    dual: "Dual (Voronoi)",
    circles: "Diametral circles",
    halfEdges: "Half-edges",
    nearest: "Nearest vertex",
    triangle: "Triangle",
  },
  about: {
    marks:
      "What the step is about: green comes or may stay, red (broken, crosses) goes or must, amber (rings) is looked at.",
    circle:
      "The last test of a circle: does the fourth point lie inside? The answer is exact. If it lies on the circle, the rightmost of the four counts as lifted a little, which decides.",
    walk: "The triangles and edges visited since this turn began, in their order, until something is made of what was found.",
    waiting:
      "What waits to be looked at, numbered in the order in which it came. What goes first is drawn stronger.",
    front: "The boundary of what a sweep has finished; for Fortune's algorithm the beach line.",
    sweep: "The line or circle that sweeps over the plane.",
    rays: "Who sees whom: broken where something is in the way.",
    encroached:
      "The segment that a vertex is too close to, with its diametral circle; or would be, if it were put where it was meant to be.",
    clusters: "The centers of the clusters of data.",
    holders: "For which triangle each datum counts, and how many data each triangle holds.",
    numbers: "The numbers of the vertices. They fade when there are too many: zoom in.",
    illegal: "Edges that are not locally Delaunay: the circle of one side holds the corner of the other.",
    cocircular: "Quadrilaterals whose four corners lie on one circle, exactly: both diagonals would do.",
    voronoi:
      "What is nearer to each point than to any other, whatever triangles there are. Of very many cells nothing is drawn: zoom in.",
    dual: "The circumcenters of neighbours joined. Where the triangulation is Delaunay, these are the borders of the Voronoi cells.",
    circles: "The smallest circle around each constraint. Red: a corner next to it lies inside.",
    halfEdges:
      "The half-edge beside the pointer, its twin, and the next and previous ones about triangle and origin.",
    nearest: "The vertex nearest to the pointer, and the walk through the triangles by which it is found.",
    triangle: "The triangle under the pointer, and whether its circumcircle is empty.",
  },
  hint: "Point at a switch to read what it shows.",
  reset: "As usual",
  sides: { inside: "inside", outside: "outside" },
  onCircle: (counts: string) => `on the circle: ${counts}`,
  raised: "lifted",
  circleHolds: (inside: number, on: number) =>
    `${inside === 0 ? "empty" : `${inside} inside`}${on === 0 ? "" : `, ${on} on the circle`}`,
  waiting: {
    heading: "What waits",
    queues: {
      suspects: "Suspects",
      search: "Search",
      cavity: "Cavity",
      events: "Events",
      crossings: "Crossings",
    },
    next: "goes first",
    more: (count: string) => `and ${count} more`,
    vertex: (v: string) => `vertex ${v}`,
    edge: (a: string, b: string) => `edge ${a}–${b}`,
    triangle: (a: string, b: string, c: string) => `triangle ${a}, ${b}, ${c}`,
  },
  lift: {
    show: "Lifted view",
    about:
      "Each point raised to the height x² + y²: the Delaunay triangles are the facets of the lower hull. Red edges bend the wrong way.",
    label:
      "The triangulation lifted to a paraboloid. Drag or use the arrow keys to turn it, Home to look from the side again.",
    height: "Height",
    flat: "flat",
    lifted: "lifted",
    close: "Close the lifted view",
    none: "There are no triangles yet.",
    tooMany: (most: string) => `More than ${most} triangles are not lifted.`,
    bent: (count: number) =>
      count === 1 ? "1 edge bends the wrong way" : `${count} edges bend the wrong way`,
    convex: "convex: every edge is locally Delaunay",
  },
};
