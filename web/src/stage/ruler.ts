// Lengths and places in words: the scale bar, and coordinates with as many digits as the view can tell apart.

/** The least and the most pixels of the scale bar. */
const WIDEST = 120;

/** Beyond these powers of ten numbers are written with a power of ten. */
const LARGE = 7;
const SMALL = -5;

/** Returns the longest length of 1, 2 or 5 times a power of ten that fits into the scale bar, and its pixels. */
export function barFor(scale: number): { length: number; pixels: number } {
  const most = WIDEST / scale;
  const power = Math.floor(Math.log10(most));
  for (const digit of [5, 2, 1]) {
    const length = tens(digit, power);
    if (length <= most && length > 0) return { length, pixels: length * scale };
  }
  // The logarithm was rounded up.
  const length = tens(5, power - 1);
  return { length, pixels: length * scale };
}

/** Writes a length that has one digit. */
export function lengthText(length: number, language: string): string {
  const power = Math.round(Math.log10(length) - 0.35);
  return text(length, power, 0, language);
}

/** Writes a coordinate; `pixel` is the length of a pixel, of which digits tell a tenth at least. */
export function coordinateText(value: number, pixel: number, language: string): string {
  const last = Math.floor(Math.log10(pixel));
  const first = value === 0 ? last : Math.floor(Math.log10(Math.abs(value)));
  // A number has no more than 17 digits that say anything.
  return text(value, first, Math.max(0, Math.min(first - last, 16)), language);
}

/** Writes a number whose first digit is that of 10^first, with so many digits behind it. */
function text(value: number, first: number, digits: number, language: string): string {
  const isPlain = value === 0 || (first < LARGE + digits / 2 && first < 12 && first > SMALL);
  if (isPlain) {
    const decimals = Math.max(0, Math.min(digits - first, 20));
    return value.toLocaleString(language, {
      minimumFractionDigits: value === 0 ? 0 : decimals,
      maximumFractionDigits: decimals,
    });
  }
  const [mantissa, power] = value.toExponential(Math.min(digits, 20)).split("e");
  const factor = Number(mantissa).toLocaleString(language, {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
  });
  return `${factor}·10${raised(Number(power))}`;
}

/** Reads what is written, which rounds once; powers of ten would be rounded before. */
const tens = (digit: number, power: number): number => Number(`${digit}e${power}`);

const raised = (power: number): string =>
  [...String(power)].map((each) => (each === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(each)])).join("");
