// What is asked about a run that is gone by then has no answer, as if the question had been cancelled: a worker that was
// ended comes back with the runs that there are, and not with those that were being made.

/** The message of an error of the worker: there is no run in the slot that is asked about. */
export const GONE = "no run is here";
