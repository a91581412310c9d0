// The facets of a lifted scene. Those whose upper side is seen, the inside of the bowl, come first: all of them lie
// behind those that are seen from outside. On each side from far to near; the edges of a side at once, which is
// quicker by far than facet by facet, and right where the bowl is convex.

import { type Links, OUTSIDE } from "../see/links";
import type { Palette } from "../stage/palette";
import { pale } from "../stage/palette";
import type { Sheet } from "./draw";
import { lightOn, paintersOrder } from "./project";

/** Steps from dark to bright. */
const SHADES = 48;

/** Lines that are stroked at once; of very many canvases make a slow path. */
const BATCH = 1000;

/** Draws the facets. */
export function drawFacets(sheet: Sheet, links: Links, seen: Float64Array): void {
  const { triangles } = links;
  const pixels = pixelsOf(sheet, seen);
  const light = new Float64Array(triangles.length / 3);
  for (let t = 0; t < light.length; t++) {
    light[t] = lightOn(seen, triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]);
  }
  const order = paintersOrder(triangles, seen);
  const colours = shadesOf(sheet.palette);
  for (const side of [1, -1]) {
    const facets = order.filter((t) => light[t] * side > 0);
    for (const t of facets) fillFacet(sheet, triangles, pixels, t, colours(light[t]));
    strokeEdges(sheet, links, pixels, facets);
  }
}

function fillFacet(
  { context }: Sheet,
  triangles: Uint32Array,
  pixels: Float64Array,
  t: number,
  colour: string,
): void {
  context.beginPath();
  for (let h = 3 * t; h < 3 * t + 3; h++) {
    const v = 2 * triangles[h];
    context.lineTo(pixels[v], pixels[v + 1]);
  }
  context.fillStyle = colour;
  context.fill();
}

/** Strokes each edge of the facets, those between two of them once or twice. */
function strokeEdges(
  { context, palette }: Sheet,
  links: Links,
  pixels: Float64Array,
  facets: Uint32Array,
): void {
  context.strokeStyle = palette.edge;
  context.lineWidth = links.triangles.length > 9_000 ? 0.4 : 0.9;
  for (let i = 0; i < facets.length; i += BATCH) {
    context.beginPath();
    for (const t of facets.subarray(i, i + BATCH)) {
      for (let h = 3 * t; h < 3 * t + 3; h++) {
        const [v, w] = [2 * links.origin(h), 2 * links.dest(h)];
        if (v > w && links.twins[h] !== OUTSIDE) continue;
        context.moveTo(pixels[v], pixels[v + 1]);
        context.lineTo(pixels[w], pixels[w + 1]);
      }
    }
    context.stroke();
  }
}

function pixelsOf(sheet: Sheet, seen: Float64Array): Float64Array {
  const pixels = new Float64Array((2 * seen.length) / 3);
  for (let v = 0; 3 * v < seen.length; v++) pixels.set(sheet.at(seen[3 * v], seen[3 * v + 1]), 2 * v);
  return pixels;
}

/** Returns the colour for a light: the inside of the bowl is bright, its outside in the shade. */
function shadesOf({ fill, locked, paper }: Palette): (light: number) => string {
  const steps = Array.from({ length: SHADES + 1 }, (_, i) => i / SHADES);
  const inside = steps.map((light) => pale(mix(fill, paper, 0.8 * light), 0.9));
  const outside = steps.map((light) => pale(mix(fill, locked, 0.12 + 0.4 * (1 - light)), 0.9));
  return (light) => (light > 0 ? inside : outside)[Math.round(SHADES * Math.abs(light))];
}

/** Mixes two colours, `#rrggbb`. */
export function mix(one: string, other: string, share: number): string {
  const [a, b] = [one, other].map((hex) => Number.parseInt(hex.slice(1), 16));
  const channels = [16, 8, 0].map((shift) => {
    const [from, to] = [(a >> shift) & 255, (b >> shift) & 255];
    return Math.round(from + share * (to - from))
      .toString(16)
      .padStart(2, "0");
  });
  return `#${channels.join("")}`;
}
