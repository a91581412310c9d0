// What moves a run that plays: so many steps a second, and fewer pictures if that is more than the screen shows.

import { effect } from "@preact/signals";
import { isPlaying, position, run, seek, speed } from "../state/play";

effect(() => {
  if (!isPlaying.value) return;
  let [last, rest, request] = [performance.now(), 0, 0];
  const tick = (now: number) => {
    rest += (speed.peek() * Math.min(now - last, 250)) / 1000;
    last = now;
    const steps = Math.floor(rest);
    rest -= steps;
    if (steps > 0) seek(position.peek() + steps);
    if (position.peek() >= (run.peek()?.length ?? 0)) isPlaying.value = false;
    else request = requestAnimationFrame(tick);
  };
  // Whoever plays at the end begins again.
  if (position.peek() >= (run.peek()?.length ?? 0)) seek(0);
  request = requestAnimationFrame(tick);
  return () => cancelAnimationFrame(request);
});
