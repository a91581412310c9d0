// The triangle that somebody asks about, and what there is to say of it.

import { batch, computed, effect, signal } from "@preact/signals";
import type { Explanation } from "../engine/protocol";
import { askMesh, isOutdated, mesh } from "../state/mesh";
import { language } from "../state/settings";
import { tab } from "./tab";
import { across, edgeToward, insideOf } from "./walk";

/** The number of the triangle; null: none. */
export const chosen = signal<number | null>(null);

/** What there is to say of it; of the one before until the answer is there. */
export const told = signal<{ explanation: Explanation; sentence: string } | null>(null);

/** Which of its corners is looked at: 0, 1 or 2. */
export const corner = signal(0);

/** Whether triangles can be asked about: not those of a drawing that is another one by now. */
export const canAsk = computed(() => mesh.value !== null && !isOutdated.value);

/** Chooses a triangle, and opens what there is to say of it. */
export function choose(triangle: number): void {
  chosen.value = triangle;
  tab.value = "triangle";
}

/** Chooses the triangle at a place; none if there is none. */
export async function chooseAt(x: number, y: number): Promise<void> {
  if (!canAsk.peek()) return;
  const found = await triangleAt(x, y);
  if (found === undefined) close();
  else choose(found);
}

const triangleAt = (x: number, y: number): Promise<number | undefined> =>
  askMesh((engine) => engine.meshes.triangleAt(x, y));

/** Asks no more. */
export function close(): void {
  chosen.value = null;
}

/** Goes to the triangle across the edge opposite a corner, if there is one. */
export function goAcross(k: number): void {
  const [of, from] = [mesh.peek(), chosen.peek()];
  if (of && from !== null) chosen.value = across(of, from, k) ?? from;
}

/** Goes to the neighbour that lies most in a direction. */
export function goToward(direction: readonly [number, number]): void {
  const [of, from] = [mesh.peek(), chosen.peek()];
  if (of && from !== null) goAcross(edgeToward(of, from, direction));
}

effect(() => {
  const [of, t, words] = [mesh.value, chosen.value, language.value];
  if (!of || t === null) {
    told.value = null;
    return;
  }
  void askMesh(async (engine) => ({
    explanation: await engine.meshes.explain(t),
    sentence: await engine.meshes.sentence(t, words),
  })).then((answer) => {
    if (!answer || chosen.peek() !== t || mesh.peek() !== of) return;
    batch(() => {
      if (told.peek()?.explanation.triangle !== t) corner.value = youngest(answer.explanation);
      told.value = answer;
    });
  });
});

/** The corner that came last: only with it could there be this triangle. */
function youngest({ vertices }: Explanation): number {
  const numbers = vertices.map(({ vertex }) => vertex);
  return numbers.indexOf(Math.max(...numbers));
}

// In another mesh of the same drawing the triangle at the same place is asked about.
let before = mesh.peek();
effect(() => {
  const [was, now, t] = [before, mesh.value, chosen.peek()];
  if (was === now) return;
  before = now;
  chosen.value = null;
  if (was && now && t !== null) void keep(insideOf(was, t));
});

async function keep(place: [number, number]): Promise<void> {
  const of = mesh.peek();
  const found = await triangleAt(...place);
  if (mesh.peek() === of && chosen.peek() === null) chosen.value = found ?? null;
}
