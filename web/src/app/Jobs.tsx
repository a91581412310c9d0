// Long work: how far it is, and how to stop it.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { cancelJobs, type Job, jobs } from "../state/job";
import { count, words } from "../words";

/** Milliseconds after which work counts as long. */
const PATIENCE = 300;

export function Jobs() {
  const [job] = jobs.value;
  return job ? <Bar key={job.since} job={job} /> : null;
}

function Bar({ job }: { job: Job }) {
  const isLong = useSignal(false);
  useEffect(() => {
    const timer = setTimeout(() => {
      isLong.value = true;
    }, PATIENCE);
    return () => clearTimeout(timer);
  }, [isLong]);
  if (!isLong.value) return null;
  const say = words.value.app;
  return (
    <div class="job">
      {/* Only what is done is read out, not every figure on the way. */}
      <span role="status">{say.jobs[job.name]}</span>
      {job.total > 0 ? (
        <progress value={job.done} max={job.total} aria-label={say.jobs[job.name]} />
      ) : (
        <progress aria-label={say.jobs[job.name]} />
      )}
      {job.done > 0 && <span class="figure">{count(job.done)}</span>}
      <button type="button" onClick={cancelJobs}>
        {say.cancel}
      </button>
    </div>
  );
}
