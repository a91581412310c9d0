// The stages of a race: one for each racer, with one camera.

import { type ReadonlySignal, type Signal, useComputed } from "@preact/signals";
import { titleOf } from "../play/described";
import type { Camera } from "../stage/camera";
import { Stage } from "../stage/Stage";
import { emptyScene, type StageScene, sceneOfDrawing } from "../stage/scene";
import { drawing } from "../state/drawing";
import { clock, isLiningUp, type Lane, lanes, lineUp } from "../state/race";
import { count, words } from "../words";
import { laneMarks } from "./laneMarks";
import { places, testsOf } from "./racing";
import "./race.css";

interface Props {
  camera: Signal<Camera | null>;
  /** The points that are brought into view. */
  whole: ReadonlySignal<Float64Array>;
  /** What the drawing comes from. */
  source: ReadonlySignal<unknown>;
}

export function RaceStages({ camera, whole, source }: Props) {
  const all = lanes.value;
  const order = places(
    all.map(({ totals }) => totals),
    clock.value,
  );
  if (all.length === 0) return <Nobody />;
  return (
    <div class="lanes" data-lanes={all.length}>
      {all.map((lane, i) => (
        <LaneStage
          key={lane.slot}
          lane={lane}
          place={order[i]}
          camera={camera}
          whole={whole}
          source={source}
        />
      ))}
    </div>
  );
}

/** Racers are being run, or somebody has cancelled that. */
function Nobody() {
  const say = words.value.race;
  return (
    <div class="lanes-none">
      {isLiningUp.value ? (
        <p class="quiet">{say.waiting}</p>
      ) : (
        <button type="button" onClick={() => void lineUp()}>
          {say.lineUp}
        </button>
      )}
    </div>
  );
}

function LaneStage({ lane, place, camera, whole, source }: Props & { lane: Lane; place: number }) {
  const scene = useComputed<StageScene>(() => {
    const drawn = drawing.value;
    if (lane.frame.value) return { ...lane.frame.value, values: null, hasDots: true };
    return drawn ? sceneOfDrawing(drawn.points, drawn.segments) : emptyScene;
  });
  const overlays = useComputed(() => [laneMarks(lane)]);
  const description = useComputed(() => words.value.race.stage(titleOf(lane.run.algorithm, lane.run.title)));
  return (
    <article class="lane">
      <LaneHead lane={lane} place={place} />
      <Stage
        scene={scene}
        overlays={overlays}
        camera={camera}
        whole={whole}
        source={source}
        description={description}
      />
    </article>
  );
}

function LaneHead({ lane: { frame, run }, place }: { lane: Lane; place: number }) {
  const say = words.value.race;
  const shown = frame.value;
  const isThere = shown !== null && shown.position === run.length;
  const done = shown?.tally;
  return (
    <header class="lane-head">
      <h2>
        {titleOf(run.algorithm, run.title)}
        {isThere && (
          <span class={place === 1 ? "medal first" : "medal"} title={say.finishedHint(place)}>
            {say.finished(place)}
          </span>
        )}
      </h2>
      <progress value={shown?.position ?? 0} max={Math.max(1, run.length)} aria-label={say.position} />
      <dl class="figure">
        <div>
          <dt>{say.lane.tests}</dt>
          <dd>{count(done ? testsOf(done) : 0)}</dd>
        </div>
        <div>
          <dt>{say.lane.steps}</dt>
          <dd>{count(done?.steps ?? 0)}</dd>
        </div>
        <div>
          <dt>{say.lane.flips}</dt>
          <dd>{count(done?.flips ?? 0)}</dd>
        </div>
      </dl>
    </header>
  );
}
