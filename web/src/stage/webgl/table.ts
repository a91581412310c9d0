// Long lists on the graphics processor: textures of many rows, of which shaders read single cells.

import type { Gl } from "./program";

/** How many cells a row has. WebGL promises only half of that, but there is hardly a device that has not more. */
export const WIDTH = 4096;

/** A list of numbers: one or two of 32 bits in each cell, whole ones or not. */
export class Table {
  readonly texture: WebGLTexture;

  /** Uploads a list. Throws a `RangeError` if it is longer than the device can hold. */
  constructor(
    private readonly gl: Gl,
    list: Float32Array | Uint32Array,
    perCell: 1 | 2,
  ) {
    const cells = list.length / perCell;
    const rows = Math.max(1, Math.ceil(cells / WIDTH));
    const most: number = gl.getParameter(gl.MAX_TEXTURE_SIZE) ?? 0;
    if (Math.max(rows, Math.min(cells, WIDTH)) > most) throw new RangeError("more than this device can draw");
    const { inner, format, type } = layout(gl, list, perCell);
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    }
    const width = rows === 1 ? Math.max(1, cells) : WIDTH;
    gl.texStorage2D(gl.TEXTURE_2D, 1, inner, width, rows);
    // Full rows at once, then what is left: so nothing is copied to be padded.
    const full = Math.floor(cells / width);
    const rest = cells % width;
    const put = (row: number, wide: number, high: number) =>
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, wide, high, format, type, list, row * width * perCell);
    if (full > 0) put(0, width, full);
    if (rest > 0) put(full, rest, 1);
  }

  delete(): void {
    this.gl.deleteTexture(this.texture);
  }
}

function layout(gl: Gl, list: Float32Array | Uint32Array, perCell: 1 | 2) {
  if (list instanceof Float32Array) {
    return perCell === 1
      ? { inner: gl.R32F, format: gl.RED, type: gl.FLOAT }
      : { inner: gl.RG32F, format: gl.RG, type: gl.FLOAT };
  }
  return perCell === 1
    ? { inner: gl.R32UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_INT }
    : { inner: gl.RG32UI, format: gl.RG_INTEGER, type: gl.UNSIGNED_INT };
}

/** Uploads colours in a row, four bytes each. */
export function colourTable(gl: Gl, bytes: Uint8Array): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, bytes.length / 4, 1);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, bytes.length / 4, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
    gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  }
  return texture;
}
