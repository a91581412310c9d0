// A program of the graphics processor, and its uniforms by name.

export type Gl = WebGL2RenderingContext;

/** What uniforms are set to: numbers, vectors, and tables, which take the texture units in turn. */
export type Uniform = number | boolean | readonly number[] | WebGLTexture;

export class Program {
  private readonly program: WebGLProgram;
  private readonly places = new Map<string, WebGLUniformLocation>();
  private readonly kinds = new Map<string, number>();

  /** Throws if the browser does not take the shaders. */
  constructor(
    private readonly gl: Gl,
    vertex: string,
    fragment: string,
  ) {
    this.program = gl.createProgram();
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      // Kept as long as the program is.
      gl.deleteShader(shader);
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(gl.getProgramInfoLog(this.program) ?? "the browser takes no shaders");
    }
    this.findUniforms();
  }

  /** Makes the program the current one, with these uniforms. */
  use(uniforms: Record<string, Uniform>): void {
    this.gl.useProgram(this.program);
    let unit = 0;
    for (const [name, value] of Object.entries(uniforms)) {
      const place = this.places.get(name);
      if (!place) continue;
      if (value instanceof WebGLTexture) this.bind(place, value, unit++);
      else this.set(place, this.kinds.get(name)!, value);
    }
  }

  delete(): void {
    this.gl.deleteProgram(this.program);
  }

  private findUniforms(): void {
    const { gl, program } = this;
    const count: number = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) ?? 0;
    for (let k = 0; k < count; k++) {
      const { name, type } = gl.getActiveUniform(program, k)!;
      this.places.set(name, gl.getUniformLocation(program, name)!);
      this.kinds.set(name, type);
    }
  }

  private bind(place: WebGLUniformLocation, texture: WebGLTexture, unit: number): void {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(place, unit);
  }

  private set(place: WebGLUniformLocation, kind: number, value: number | boolean | readonly number[]): void {
    const { gl } = this;
    if (typeof value === "object") gl[value.length === 2 ? "uniform2fv" : "uniform4fv"](place, value);
    else if (kind === gl.FLOAT) gl.uniform1f(place, Number(value));
    else gl.uniform1i(place, Number(value));
  }
}
