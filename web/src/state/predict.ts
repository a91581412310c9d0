// The guessing game: the run stands before a flip, and somebody says which edge it will be. The score is kept as long
// as the page is open.

import { batch, computed, effect, signal } from "@preact/signals";
import type { Judged } from "../engine/protocol";
import { innerEdges, keyOf, type Quad } from "../predict/edges";
import { judge, noScore, offer, scored, type Verdict } from "../predict/game";
import { mode } from "./mode";
import { tell } from "./notices";
import { askRun, isPlaying, position, run, seek } from "./play";
import { language } from "./settings";

export interface Puzzle {
  /** Where the run stands: behind the last change before the flip. */
  position: number;
  /** Behind the flip. */
  flip: number;
  points: Float64Array;
  /** All edges that might be flipped. */
  all: Quad[];
  answer: Quad;
  /** Names of the edges that are not locally Delaunay. */
  illegal: ReadonlySet<string>;
  /** The edges of the easy game. */
  offered: Quad[];
  /** Whether a circle is the reason; sweeps flip for others. */
  isByCircle: boolean;
  /** What the run has said of the test that has decided. */
  before: string;
}

/** Why an edge is flipped, or is not. */
export interface Reason extends Judged {
  quad: Quad;
}

export interface Answered {
  guess: Quad;
  verdict: Verdict;
  /** The edge that is flipped. */
  because: Reason | null;
  /** The edge that was guessed, if it is another one. */
  instead: Reason | null;
}

/** all: any edge. three: one of three. */
export const difficulty = signal<"all" | "three">("three");

/** The puzzle; null while there is none: it is being made, or no flip is left. */
export const puzzle = signal<Puzzle | null>(null);
export const isOver = signal(false);
export const answered = signal<Answered | null>(null);
export const isHinted = signal(false);
export const score = signal(noScore);

/** The edge that the keyboard has chosen; -1: none. */
export const cursor = signal(-1);

/** The edges that may be guessed now. */
export const guessable = computed<Quad[]>(() => {
  if (!puzzle.value || answered.value) return [];
  return difficulty.value === "three" ? puzzle.value.offered : puzzle.value.all;
});

/** Puts the puzzle of the next flip after a position; from the beginning if none is left there. */
export async function ask(from: number): Promise<void> {
  const of = run.peek();
  if (!of) return;
  batch(clear);
  try {
    const made = await make(from);
    if (run.peek() !== of || mode.peek() !== "predict") return;
    puzzle.value = made;
    isOver.value = made === null;
    if (made) seek(made.position);
  } catch (error) {
    tell(error);
  }
}

function clear(): void {
  puzzle.value = null;
  isOver.value = false;
  answered.value = null;
  isHinted.value = false;
  cursor.value = -1;
}

/** The next puzzle, once this one is answered. */
export function askNext(): void {
  if (puzzle.peek() && answered.peek()) void ask(puzzle.peek()!.flip);
}

async function make(from: number): Promise<Puzzle | null> {
  const flip = await askRun(({ players }, slot) => players.find(slot, "next", "flip", from));
  if (flip === undefined) return null;
  const before = await askRun(({ players }, slot) => players.find(slot, "previous", "change", flip));
  const at = before ?? 0;
  const said = language.peek();
  const tested = await askRun(({ players }, slot) => players.find(slot, "previous", "test", flip));
  const [scene, step, test, { illegal: rows }] = await Promise.all([
    askRun(({ players }, slot) => players.frame(slot, at, said)),
    askRun(({ players }, slot) => players.tell(slot, flip, said)),
    askRun(({ players }, slot) => players.tell(slot, tested ?? 0, said)),
    askRun(({ looks }, slot) => looks.edges(slot, at)),
  ]);
  const all = innerEdges(scene);
  const flipped = flippedBy(step.step?.event);
  const answer = all.find(({ edge }) => flipped && keyOf(edge) === keyOf(flipped));
  // Some flips are no puzzle: nobody could have clicked on the edge.
  if (!answer) return make(flip);
  const isByCircle = isTestOf(answer, test.step?.event);
  const illegal = new Set<string>();
  // Where circles decide nothing, no edge has to go for them.
  for (let i = 0; i < rows.length && isByCircle; i += 4) illegal.add(keyOf([rows[i], rows[i + 1]]));
  const offered = offer(all, answer, illegal, flip);
  return {
    position: at,
    flip,
    points: scene.points,
    all,
    answer,
    illegal,
    offered,
    isByCircle,
    before: test.narration,
  };
}

function flippedBy(event: unknown): [number, number] | null {
  const flip = event as { "edge-flipped"?: { from: [number, number] } } | undefined;
  return flip?.["edge-flipped"]?.from ?? null;
}

/** Tells whether a step has tested the circle of an edge. */
function isTestOf({ edge, apexes }: Quad, event: unknown): boolean {
  const test = (event as { "circle-tested"?: { triangle: number[]; point: number } } | undefined)?.[
    "circle-tested"
  ];
  return (
    test !== undefined && [...edge, ...apexes].every((v) => v === test.point || test.triangle.includes(v))
  );
}

/** Says which edge it will be. */
export async function guess(quad: Quad): Promise<void> {
  const of = puzzle.peek();
  // While another run is made, this puzzle is about to give way to that of another one.
  if (!of || answered.peek() || !run.peek()) return;
  const verdict = judge(quad, of.answer, of.illegal);
  batch(() => {
    answered.value = { guess: quad, verdict, because: null, instead: null };
    score.value = scored(score.peek(), verdict, isHinted.peek());
  });
  if (!of.isByCircle) return;
  try {
    const because = await reason(of, of.answer);
    const instead = verdict === "right" ? null : await reason(of, quad);
    if (puzzle.peek() === of) answered.value = { guess: quad, verdict, because, instead };
  } catch (error) {
    tell(error);
  }
}

async function reason(of: Puzzle, quad: Quad): Promise<Reason | null> {
  const four: [number, number, number, number] = [...quad.edge, ...quad.apexes];
  const judged = await askRun(({ looks }, slot) => looks.judged(slot, of.position, four));
  return judged && { ...judged, quad };
}

// Whoever comes to guess is asked at once; another run asks anew.
effect(() => {
  if (mode.value !== "predict" || !run.value) return;
  isPlaying.value = false;
  const at = position.peek();
  void ask(at < run.value.length ? at : 0);
});
