// What runs on the graphics processor. No vertex has attributes: the number of the vertex is enough to look up points
// in tables, so lists are uploaded as they come. Places are relative to an anchor (`anchor.ts`); lengths are pixels of
// the device, colours are multiplied by their alpha.

import { EDGE_FADE } from "../density";
import { WIDTH } from "./table";

const common = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
`;

const view = `${common}
uniform sampler2D places;
uniform vec2 middle;
uniform float zoom;
uniform vec2 size;

ivec2 cell(int i) {
  return ivec2(i % ${WIDTH}, i / ${WIDTH});
}
// Pixels from the middle of the view, upwards.
vec2 pixel(uint vertex) {
  return (texelFetch(places, cell(int(vertex)), 0).xy - middle) * zoom;
}
vec4 onScreen(vec2 at) {
  return vec4(2.0 * at / size, 0.0, 1.0);
}
`;

/** Three vertices for each triangle. */
export const triangleVertex = `${view}
uniform usampler2D corners;
uniform sampler2D values;
uniform sampler2D ramp;
uniform bool isValued;
uniform vec4 colour;
flat out vec4 paint;

void main() {
  gl_Position = onScreen(pixel(texelFetch(corners, cell(gl_VertexID), 0).x));
  float value = isValued ? texelFetch(values, cell(gl_VertexID / 3), 0).x : 0.0;
  int step = int(round(clamp(value, 0.0, 1.0) * float(textureSize(ramp, 0).x - 1)));
  paint = isValued && value >= 0.0 ? texelFetch(ramp, ivec2(step, 0), 0) : colour;
}
`;

export const triangleFragment = `${common}
flat in vec4 paint;
out vec4 pixelColour;

void main() {
  pixelColour = paint;
}
`;

/** Six vertices for each edge: two triangles, half a pixel larger all around than the line. */
export const edgeVertex = `${view}
uniform usampler2D ends;
uniform float halfWidth;
uniform float ratio;
uniform float least;
out float across;
flat out float strength;

void main() {
  int corner = gl_VertexID % 6;
  bool isLast = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 0 || corner == 1 || corner == 3 ? 1.0 : -1.0;
  uvec2 pair = texelFetch(ends, cell(gl_VertexID / 6), 0).xy;
  vec2 from = pixel(pair.x);
  vec2 to = pixel(pair.y);
  float far = distance(from, to);
  strength = mix(least, 1.0, smoothstep(${EDGE_FADE.map((length) => length.toFixed(2)).join(", ")}, far / ratio));
  vec2 along = far > 0.0 ? (to - from) / far : vec2(1.0, 0.0);
  across = side * (halfWidth + 0.5);
  vec2 at = (isLast ? to + halfWidth * along : from - halfWidth * along) + across * vec2(-along.y, along.x);
  gl_Position = onScreen(at);
}
`;

export const edgeFragment = `${common}
uniform float halfWidth;
uniform vec4 colour;
in float across;
flat in float strength;
out vec4 pixelColour;

void main() {
  pixelColour = colour * strength * clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
}
`;

/** One vertex for each dot. */
export const dotVertex = `${view}
uniform int first;
uniform float radius;

void main() {
  gl_Position = onScreen(pixel(uint(first + gl_VertexID)));
  gl_PointSize = 2.0 * radius + 1.0;
}
`;

export const dotFragment = `${common}
uniform float radius;
uniform vec4 colour;
out vec4 pixelColour;

void main() {
  float from = distance(gl_PointCoord, vec2(0.5)) * (2.0 * radius + 1.0);
  pixelColour = colour * clamp(radius + 0.5 - from, 0.0, 1.0);
}
`;
