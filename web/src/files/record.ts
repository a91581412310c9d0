// Videos of a run: the browser records the stage while the run is stepped through, in the time that the video takes.

import { effect } from "@preact/signals";
import { Cancelled } from "../engine/client";
import type { NamedBytes, Progress } from "../engine/protocol";
import { frame, isPlaying, position, run, seek } from "../state/play";
import { Composer } from "./compose";
import { shownPositions } from "./pace";

const PER_SECOND = 25;

/** For so many frames more the end is seen. */
const HELD = 20;

/** What browsers record, the best first. */
const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/** Returns the kind of video that this browser records; null if it records none. */
export function videoKind(): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  return kinds.find((kind) => MediaRecorder.isTypeSupported(kind)) ?? null;
}

/** Returns the extension of such videos. */
export const videoExtension = (): string | null => videoKind()?.replace(/^video\/(\w+).*$/, "$1") ?? null;

/** Records the run that is on the stage. */
export async function record(
  name: string,
  { size, seconds }: { size: number; seconds: number },
  signal: AbortSignal,
  progress: Progress,
): Promise<NamedBytes> {
  isPlaying.value = false;
  const composer = new Composer(size);
  const stream = composer.canvas.captureStream(0);
  const [track] = stream.getVideoTracks() as CanvasCaptureMediaStreamTrack[];
  const recorder = new MediaRecorder(stream, { mimeType: videoKind()!, videoBitsPerSecond: 8_000_000 });
  const chunks: Blob[] = [];
  recorder.ondataavailable = ({ data }) => chunks.push(data);
  const ended = new Promise<void>((done) => {
    recorder.onstop = () => done();
  });
  recorder.start();
  try {
    const begin = performance.now();
    const length = run.peek()?.length ?? 0;
    const positions = [...shownPositions(length, seconds, PER_SECOND), ...Array(HELD).fill(length)];
    for (const [i, at] of positions.entries()) {
      await shown(at, signal);
      composer.draw();
      track.requestFrame();
      progress("recording", i + 1, positions.length);
      await until(begin + ((i + 1) * 1000) / PER_SECOND);
      signal.throwIfAborted();
    }
  } finally {
    recorder.stop();
    track.stop();
  }
  await ended;
  return { name, bytes: new Uint8Array(await new Blob(chunks).arrayBuffer()) };
}

/** Goes to a position and waits until its scene is on the stage; nobody else may go elsewhere meanwhile. */
function shown(at: number, signal: AbortSignal): Promise<void> {
  const of = run.peek();
  return new Promise((done, fail) => {
    const end = (how: () => void) => {
      // The effect may be at work just now.
      queueMicrotask(() => stop());
      signal.removeEventListener("abort", abort);
      how();
    };
    const abort = () => end(() => fail(signal.reason));
    signal.addEventListener("abort", abort);
    const stop = effect(() => {
      if (run.value !== of) end(() => fail(new Cancelled()));
      else if (position.value !== at) queueMicrotask(() => seek(at));
      else if (frame.value?.position === at) end(done);
    });
  });
}

const until = (time: number): Promise<void> =>
  new Promise((go) => setTimeout(go, Math.max(0, time - performance.now())));
