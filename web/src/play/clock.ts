// What moves a run that plays: so many steps a second, and fewer pictures if that is more than the screen shows. It
// never passes a breakpoint: where the next one stops is asked before it moves on.

import { batch, effect } from "@preact/signals";
import { active, type Stopped, stopped } from "../state/breakpoints";
import { tell } from "../state/notices";
import { heading, isPlaying, nextStop, position, run, seek, speed } from "../state/play";
import { advance, rate, secondsBetween } from "./pace";

effect(() => {
  if (!isPlaying.value) return;
  const [length, way] = [run.value?.length ?? 0, heading.value];
  void active.value;
  // Whoever plays at the end begins again.
  const [begin, end] = way === "next" ? [0, length] : [length, 0];
  if (position.peek() === end) seek(begin);

  let at = -1;
  let stop: Stopped | null | "asked" = null;
  const ask = async (from: number) => {
    at = from;
    stop = active.peek().length > 0 ? "asked" : null;
    if (stop === null) return;
    try {
      const found = await nextStop(way, from);
      if (at === from) stop = found;
    } catch (error) {
      tell(error);
      isPlaying.value = false;
    }
  };
  let [last, rest, request] = [performance.now(), 0, 0];
  const tick = (now: number) => {
    const passed = secondsBetween(last, now);
    last = now;
    request = requestAnimationFrame(tick);
    // Somebody else may have moved the run meanwhile.
    if (position.peek() !== at) void ask(position.peek());
    if (stop === "asked") return;
    rest += rate(speed.peek(), length) * passed;
    const steps = Math.floor(rest);
    rest -= steps;
    if (steps === 0) return;
    const next = advance(at, way === "next" ? steps : -steps, length, stop?.position ?? null);
    at = next.to;
    batch(() => {
      seek(next.to);
      if (next.outcome === "stopped") stopped.value = stop as Stopped;
      if (next.outcome !== "on") isPlaying.value = false;
    });
  };
  request = requestAnimationFrame(tick);
  return () => {
    cancelAnimationFrame(request);
    at = -1;
  };
});
