// The colours of values from 0 (bad) to 1 (good): from a dark blue over a green to a light yellow. In OKLab (Ottosson,
// "A perceptual color space for image processing", 2020) lightness and the blue–yellow axis, which nearly everybody sees
// alike, go up evenly; a bow towards green keeps the middle from being grey.

type Rgb = [red: number, green: number, blue: number];

/** Returns the colour of a value as style sheets write it. Values outside count as the nearer end, no number as 0. */
export function scale(value: number): string {
  return `rgb(${shade(value).join(" ")})`;
}

/** Returns the colour of a value as three numbers from 0 to 255. */
export function shade(value: number): Rgb {
  const t = Math.max(0, Math.min(value || 0, 1));
  const a = 0.01 - 0.035 * t - 0.07 * Math.sin(Math.PI * t ** 0.8);
  return fromOklab(0.34 + 0.55 * t, a, 0.255 * t - 0.105);
}

/** Returns the colours of `count` even values, four bytes each. */
export function ramp(count: number): Uint8Array {
  const bytes = new Uint8Array(4 * count);
  for (let k = 0; k < count; k++) bytes.set([...shade(k / (count - 1)), 255], 4 * k);
  return bytes;
}

function fromOklab(lightness: number, a: number, b: number): Rgb {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    encode(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** From light to what sRGB writes. */
function encode(light: number): number {
  const part = light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
  return Math.round(255 * Math.max(0, Math.min(part, 1)));
}
