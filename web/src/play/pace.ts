// How fast a run plays: the slider's scale, and how far it comes in a frame.

/** The slider goes from 0 to this; the last place means as fast as it goes. */
export const FASTEST = 100;

/** Steps a second at the slider's ends. */
const [SLOW, FAST] = [0.5, 10_000];

/** Even the longest run is over after so many seconds, played as fast as it goes. */
const SECONDS = 4;

/** Returns the speed at a place of the slider: logarithmic, rounded to two digits. */
export function speedAt(place: number): number {
  if (place >= FASTEST) return Number.POSITIVE_INFINITY;
  const speed = SLOW * (FAST / SLOW) ** (Math.max(0, place) / (FASTEST - 1));
  return Number(speed.toPrecision(2));
}

/** Returns the place of a speed on the slider. */
export function placeOf(speed: number): number {
  if (speed === Number.POSITIVE_INFINITY) return FASTEST;
  const share = Math.log(speed / SLOW) / Math.log(FAST / SLOW);
  return Math.round(Math.max(0, Math.min(1, share)) * (FASTEST - 1));
}

/** Returns how many steps a second a run of this length makes. */
export const rate = (speed: number, length: number): number =>
  speed === Number.POSITIVE_INFINITY ? Math.max(2 * FAST, length / SECONDS) : speed;

/** After a longer pause, as of a page in the background, playing goes on as if it had been this long. */
const LONGEST = 250;

/** Returns how many seconds have passed between two frames; a frame may be dated before what has begun during it. */
export const secondsBetween = (last: number, now: number): number =>
  Math.max(0, Math.min(now - last, LONGEST)) / 1000;

/** Where playing comes to: it goes on, is at the end, or has been stopped on its way. */
export interface Advance {
  to: number;
  outcome: "on" | "end" | "stopped";
}

/** Goes `steps` forwards, or backwards if they are negative, but not beyond the run or a stop. */
export function advance(at: number, steps: number, length: number, stop: number | null): Advance {
  const wanted = at + steps;
  const isBeyond = (place: number) => (steps < 0 ? wanted <= place : wanted >= place);
  if (stop !== null && isBeyond(stop)) return { to: stop, outcome: "stopped" };
  const end = steps < 0 ? 0 : length;
  return isBeyond(end) ? { to: end, outcome: "end" } : { to: wanted, outcome: "on" };
}
