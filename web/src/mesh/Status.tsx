// How far the work is, or what came of it, in a line.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { mesher } from "../engine/client";
import { type Job, jobOf } from "../state/job";
import { isOther, isOutdated, mesh } from "../state/mesh";
import { count, number, words } from "../words";
import { outcomeOf } from "./outcome";

/** Milliseconds before progress is shown: what is quicker would only flicker. */
const PATIENCE = 250;

/** How often the clock is looked at, in milliseconds. */
const TICK = 100;

export function Status() {
  const job = jobOf(mesher).value;
  const isMeshing = job?.name === "mesh";
  return <div class="mesh-status">{isMeshing ? <Working key={job.since} job={job} /> : <Outcome />}</div>;
}

function Working({ job }: { job: Job }) {
  const elapsed = useSignal(0);
  useEffect(() => {
    const timer = setInterval(() => {
      elapsed.value = performance.now() - job.since;
    }, TICK);
    return () => clearInterval(timer);
  }, [elapsed, job.since]);
  if (elapsed.value < PATIENCE) return <Outcome />;
  const say = words.value.mesh;
  const { phase, done, total } = job;
  return (
    <div>
      <div class="mesh-working">
        <span role="status">{say.phases[phase] ?? phase}</span>
        <span class="figure quiet">{say.seconds((elapsed.value / 1000).toFixed(1))}</span>
        <button type="button" onClick={() => mesher.cancel()}>
          {say.cancel}
        </button>
      </div>
      <progress max={total || 1} {...(total > 0 && { value: Math.min(done, total) })} aria-hidden="true" />
      <small class="figure quiet">
        {total > 0 ? say.progress(number(done), number(total, 2)) : "\u00a0"}
      </small>
    </div>
  );
}

function Outcome() {
  const say = words.value.mesh;
  const now = mesh.value;
  if (!now) return <p class="quiet">{say.empty}</p>;
  const { tone, name } = outcomeOf(now);
  const text = say.outcomes[name];
  const { triangles, unmet } = now.quality;
  return (
    <div role="status">
      <p class={`mesh-outcome ${tone}`}>
        {typeof text === "string"
          ? text
          : text(say.triangles(triangles, count(triangles)), say.short(unmet, count(unmet)))}
      </p>
      {(isOutdated.value || isOther.value) && (
        <p class="mesh-warning mesh-small">{isOutdated.value ? say.outdated : say.other}</p>
      )}
    </div>
  );
}
