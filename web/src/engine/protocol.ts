// What page and worker say to each other. All numbers that are many travel as typed arrays.

/** Coordinates: x, y, x, y, … */
export type Coordinates = Float64Array;
/** Indices of vertices: two for an edge, three for a triangle. */
export type Indices = Uint32Array;

/** Where a drawing comes from. */
export type Source =
  | { kind: "preset"; name: string; count: number; seed: number }
  | { kind: "files"; files: NamedBytes[] }
  | { kind: "lists"; points: Coordinates; segments: Indices; holes: Coordinates };

/** A file, by its name, whose extension tells the format. */
export interface NamedBytes {
  name: string;
  bytes: Uint8Array;
}

/** A change of a drawing. Numbers are those before the edit. */
export type Edit =
  | { addPoint: [x: number, y: number] }
  | { movePoint: [point: number, x: number, y: number] }
  | { removePoint: number }
  | { addSegment: [from: number, to: number] }
  | { removeSegment: number }
  | { addHole: [x: number, y: number] }
  | { moveHole: [hole: number, x: number, y: number] }
  | { removeHole: number }
  | { clear: true };

/** How a drawing is made: its source, and what was done to it since. Enough to make it again. */
export interface Recipe {
  source: Source;
  edits: Edit[];
}

/** A drawing, to be looked at. */
export interface DrawingData {
  points: Coordinates;
  segments: Indices;
  holes: Coordinates;
  /** Four numbers each: a place in it, its attribute, and its largest area or NaN. */
  regions: Float64Array;
  about: DrawingAbout;
}

export type Rule = "hull" | "carve" | "evenodd";

export interface DrawingAbout {
  points: number;
  segments: number;
  holes: number;
  regions: number;
  /** Triangles that a file has brought along. */
  triangles: number;
  /** Which triangles are kept unless something else is asked for. */
  rule: Rule;
  attributes: string[];
  leftOut: string[];
}

export interface Preset {
  name: string;
  about: string;
  kind: "points" | "domain" | "scene";
  /** Whether the number of points or segments can be chosen. */
  sized: boolean;
}

/** A kind of files, and what of it can be read and written. */
export interface Format {
  /** The usual one of `extensions`. */
  extension: string;
  extensions: string[];
  what: string;
  reads: boolean;
  /** A drawing with segments can be written; one without. */
  drawing: boolean;
  points: boolean;
  mesh: boolean;
  /** A mesh of triangles with six nodes. */
  quadratic: boolean;
  cells: boolean;
  report: boolean;
  run: boolean;
}

/** What a file may be opened as. */
export type FileKind = "drawing" | "log" | "unknown";

/** Where trouble is, told along with an error: in the drawing that was worked on, or in a file. */
export interface Marks {
  places: Coordinates;
  /** Numbers of segments and points. */
  segments: Indices;
  points: Indices;
  /** The line of the file, from 1. */
  line?: number | undefined;
}

/** What there is to say of an algorithm. */
export interface Algorithm {
  name: string;
  title: string;
  source: string;
  idea: string;
  cost: string;
  guarantees: string;
  takes: "points" | "triangulation" | "domain" | "data";
  delaunay: boolean;
  code: string[];
}

/** What some algorithms want to know. */
export interface RunOptions {
  seed?: number;
  minAngle?: number;
  maxEdge?: number;
  dataPerTriangle?: number;
  domain?: Rule;
}

/** A finished run, of which any step may be shown. */
export interface Run {
  algorithm: string;
  title: string;
  code: string[];
  /** How many steps there are; positions go from 0 to this. */
  length: number;
  tally: Tally;
  hash: string;
}

export interface Tally {
  steps: number;
  orientationTests: number;
  circleTests: number;
  ties: number;
  walkSteps: number;
  flips: number;
  edgesCreated: number;
  edgesDeleted: number;
  trianglesCreated: number;
  trianglesDeleted: number;
  verticesCreated: number;
  pushed: number;
  firstConflicts: number | null;
  lastConflicts: number | null;
}

/** What a race goes by: the amount that all have used. */
export const clocks = ["predicates", "milliseconds", "steps"] as const;
export type Clock = (typeof clocks)[number];

/** Numbers that change over a run, in the order in which they are shown. */
export const curves = [
  "conflicts",
  "queue",
  "triangles",
  "edges",
  "vertices",
  "flips",
  "predicates",
  "minAngle",
] as const;
export type CurveName = (typeof curves)[number];

/** What a step may be searched by. */
export type Condition =
  | { kind: string }
  | { line: number }
  | { vertex: number }
  | { edge: [number, number] }
  | { curve: CurveName; below: number }
  | { curve: CurveName; above: number }
  | { stage: string };

/** Where a search has ended, and by which of its conditions. */
export interface Stop {
  position: number;
  which: number;
}

/** What is said of a step. */
export interface Told {
  step: Step | null;
  narration: string;
}

/** A run that has not been kept: what it counts, and how long it took. */
export interface Measured {
  algorithm: string;
  tally: Tally;
  hash: string;
  milliseconds: number;
}

/** good: comes, or may stay. bad: goes, or must. asked: is looked at. */
export type Tone = "good" | "bad" | "asked";

/** Something that a step is about, to be drawn over the scene. */
export type Mark =
  | { shape: "vertex"; tone: Tone; vertex: number }
  | { shape: "edge"; tone: Tone; edge: [number, number] }
  | { shape: "triangle"; tone: Tone; triangle: [number, number, number] }
  | { shape: "circle"; tone: Tone; center: [number, number]; radius: number }
  | { shape: "place"; tone: Tone; at: [number, number] }
  | { shape: "cut"; tone: Tone; cut: { vertical: number } | { horizontal: number } };

/** The step that has just been taken. */
export interface Step {
  /** The line of the pseudocode, from 1; 0 for what lays out the beginning. */
  line: number;
  kind: string;
  event: unknown;
  marks: Mark[];
}

export type Sweep =
  | { vertical: number }
  | { horizontal: number }
  | { circle: { center: [number, number]; radius: number } };

export const queues = ["suspects", "search", "cavity", "events", "crossings"] as const;
export type Queue = (typeof queues)[number];

/** The scene between two steps. */
export interface Frame {
  position: number;
  points: Coordinates;
  edges: Indices;
  /** For each edge 1 if it is a constraint, else 0. */
  locked: Uint8Array;
  triangles: Indices;
  /** The vertices of the front, in order. */
  front: Indices;
  sweep: Sweep | null;
  /** Three numbers for each that waits: a triangle; an edge and NONE; a vertex and NONE twice. */
  waiting: Partial<Record<Queue, Indices>>;
  /** Number, x and y of each cluster's center. */
  clusters: Float64Array;
  step: Step | null;
  narration: string;
  /** What has been done up to here. */
  tally: Tally;
}

/** Stands for no vertex. */
export const NONE = 0xffffffff;

export type Language = "en" | "de";

export type Direction = "next" | "previous";

/** What is asked of a mesh. */
export interface MeshOptions {
  domain?: Rule;
  crossings?: "error" | "split";
  /** Degrees; 0: none. */
  minAngle?: number;
  maxEdge?: number;
  maxArea?: number;
  regionAreas?: boolean;
  maxVertices?: number;
  smoothing?: number;
  conforming?: boolean;
  thesis?: boolean;
}

/** Points alone; points and segments; or these and vertices added until triangles are good. */
export type MeshKind = "triangulate" | "constrain" | "refine";

export interface MeshData {
  kind: MeshKind;
  points: Coordinates;
  triangles: Indices;
  edges: Indices;
  constrained: Indices;
  /** For each edge 1 if it is a constraint, else 0. */
  locked: Uint8Array;
  /** The triangles that are not as asked. */
  unmet: Indices;
  hash: string;
  quality: Quality;
  /** How long the work took, in milliseconds, without carrying data to the page. */
  milliseconds: number;
}

export interface Quality {
  vertices: number;
  triangles: number;
  edges: number;
  duplicates: number;
  constrainedEdges: number;
  crossingsSplit: number;
  steiner: number;
  outcome: "complete" | "budgetExhausted" | "precisionLimit" | "cancelled" | "fellBack" | "other" | null;
  unmet: number;
  unexcused: number;
  minAngle: number | null;
  maxAngle: number | null;
  meanMinAngle: number | null;
  shortestEdge: number | null;
  longestEdge: number | null;
  smallestArea: number | null;
  largestArea: number | null;
  area: number;
  minAngles: number[];
}

/** What can be measured of a triangle: angles are degrees; a ratio is 1 for an equilateral triangle, 0 for a flat one. */
export const measures = ["minAngle", "maxAngle", "area", "longestEdge", "radiusRatio", "region"] as const;
export type Measure = (typeof measures)[number];

type Spot = [x: number, y: number];

/** All that there is to say of a triangle. */
export interface Explanation {
  triangle: number;
  corners: [number, number, number];
  /** Degrees. */
  angles: [number, number, number];
  /** Lengths, each opposite its corner. */
  edges: [number, number, number];
  area: number;
  region: number | null;
  unmet: Shortfall | null;
  vertices: [Corner, Corner, Corner];
  circumcenter: Spot | null;
  radius: number | null;
  /** Whether no vertex at all lies within its circle, not even behind segments. */
  isDelaunay: boolean;
}

/** What a triangle lacks, and why. */
export interface Shortfall {
  /** `angle`, `edge`, `area`; several with blanks between. */
  broken: string;
  reason: "smallInputAngle" | "lockedBoundary" | "precision" | "gradation" | "stopped" | "other";
  excused: boolean;
  corner: number | null;
  segments: [number, number] | null;
  /** Between the segments, in degrees. */
  angle: number | null;
}

export interface Corner {
  vertex: number;
  at: Spot;
  origin: "input" | "crossing" | "onSegment" | "free";
  /** The segment that it lies on; null on the hull. */
  segment: number | null;
  /** The segments that cross there. */
  segments: [number, number] | null;
  cause: Cause | null;
}

/** Why a vertex was added. */
export interface Cause {
  rule: "circumcenter" | "rejectedCircumcenter" | "encroachment" | "size" | "lattice";
  /** The corners of the triangle that was to go, or the ends of the edge that was divided. */
  parent: Spot[];
  edge: [Spot, Spot] | null;
  /** The vertex that lay too close to that edge. */
  by: number | null;
  step: number;
}

export interface SaveOptions {
  oneBased?: boolean;
  quadratic?: boolean;
  size?: number;
  legend?: boolean;
}

export interface RunSaveOptions {
  size?: number;
  seconds?: number;
  perSecond?: number;
  maxFrames?: number;
  frames?: number;
  changesOnly?: boolean;
}

/** Told now and then how far work has come; `total` is 0 if nobody knows. */
export type Progress = (phase: string, done: number, total: number) => void;

/** A step of the past. */
export interface Happening {
  /** The position at which it had just been taken. */
  position: number;
  kind: string;
  event: Record<string, unknown>;
}

/** In which order things wait. */
export interface Arrivals {
  /** For each row of `Frame.waiting` its place in the order in which they came, from 1; 0: longer ago than was looked. */
  ranks: Partial<Record<Queue, number[]>>;
  /** What will be taken out first; null if that is not soon. */
  next: { queue: Queue; row: [number, number, number] } | null;
}

/** Edges with their two ends and the two corners opposite: four numbers each. */
export interface JudgedEdges {
  /** The four lie on one circle, exactly. */
  cocircular: Indices;
  /** Not locally Delaunay, and not locked. */
  illegal: Indices;
}

/** Where a point lies relative to a circle, and for which it counts: on the circle, the perturbation decides. */
export interface CircleSide {
  side: "inside" | "on" | "outside";
  counts: "inside" | "outside";
}

/** The same, with the circle, rounded. */
export interface Judged extends CircleSide {
  circle: { center: [number, number]; radius: number } | null;
}

/** The vertex nearest to a place, and the triangles through which the search has come. */
export interface Nearest {
  vertex: number;
  distance: number;
  walk: number[];
}
