// All about the triangle that is asked about.

import { AcrossIcon } from "../app/icons";
import type { Corner, Explanation, Shortfall } from "../engine/protocol";
import { mesh } from "../state/mesh";
import { count, words } from "../words";
import { canAsk, chosen, close, corner, goAcross, told } from "./inspect";
import { degrees, size } from "./writing";

export function Triangle() {
  const say = words.value.mesh;
  if (!mesh.value) return <p class="quiet">{say.empty}</p>;
  if (!canAsk.value) return <p class="mesh-warning">{say.outdated}</p>;
  const now = told.value;
  if (chosen.value === null || !now) return <p class="quiet">{say.triangle.hint}</p>;
  const { explanation, sentence } = now;
  return (
    <article aria-labelledby="mesh-triangle">
      <header class="mesh-card">
        <h3 id="mesh-triangle">{say.triangle.heading(count(explanation.triangle))}</h3>
        <button type="button" onClick={close}>
          {say.triangle.close}
        </button>
      </header>
      <p aria-live="polite" class="mesh-sentence">
        {sentence}
      </p>
      <p class="quiet mesh-small">{say.triangle.keys}</p>
      {explanation.unmet && <Lack of={explanation.unmet} />}
      <Corners of={explanation} />
      <Facts of={explanation} />
      <h4>{say.triangle.vertices}</h4>
      {explanation.vertices.map((vertex, k) => (
        <Origin key={vertex.vertex} of={vertex} k={k} />
      ))}
      <Legend cause={explanation.vertices[corner.value].cause} />
    </article>
  );
}

function Lack({ of }: { of: Shortfall }) {
  const say = words.value.mesh;
  const broken = of.broken.split(" ").map((each) => say.unmet.broken[each] ?? each);
  return (
    <p class={`mesh-lack ${of.excused ? "" : "bad"}`}>
      <b>
        {say.triangle.fallsShort}: {broken.join(", ")}
      </b>
      {" – "}
      {say.unmet.reasons[of.reason]}
      {of.angle !== null && of.corner !== null && (
        <> ({say.triangle.inputAngle(degrees(of.angle), count(of.corner))})</>
      )}
      . {of.excused ? say.triangle.excused : say.triangle.unexcused}
    </p>
  );
}

function Corners({ of: { corners, angles, edges } }: { of: Explanation }) {
  const say = words.value.mesh.triangle;
  return (
    <table class="mesh-corners">
      <thead>
        <tr>
          <th scope="col">{say.corner}</th>
          <th scope="col">{say.angle}</th>
          <th scope="col">{say.opposite}</th>
        </tr>
      </thead>
      <tbody>
        {corners.map((vertex, k) => {
          const [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]].map((v) => count(v));
          return (
            <tr key={vertex}>
              <th scope="row" class="figure">
                {count(vertex)}
              </th>
              <td class="figure">{degrees(angles[k])}</td>
              <td class="figure">
                {size(edges[k])}{" "}
                <button
                  type="button"
                  aria-label={say.across(a, b)}
                  title={say.across(a, b)}
                  onClick={() => goAcross(k)}
                >
                  <AcrossIcon />
                </button>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function Facts({ of: { area, region, radius, isDelaunay } }: { of: Explanation }) {
  const say = words.value.mesh.triangle;
  return (
    <dl class="mesh-facts">
      <dt>{say.area}</dt>
      <dd class="figure">{size(area)}</dd>
      <dt>{say.region}</dt>
      <dd class="figure">{region === null ? say.noRegion : count(region)}</dd>
      <dt>{say.radius}</dt>
      <dd class="figure">{radius === null ? "–" : size(radius)}</dd>
      <dt>{say.circle}</dt>
      <dd>{isDelaunay ? say.isEmpty : say.isBehind}</dd>
    </dl>
  );
}

/** Where a corner comes from; the one that is chosen is explained on the stage. */
function Origin({ of, k }: { of: Corner; k: number }) {
  const say = words.value.mesh.triangle;
  const isShown = corner.value === k;
  const { cause } = of;
  return (
    <button
      type="button"
      class="mesh-origin"
      aria-pressed={isShown}
      title={say.show(count(of.vertex))}
      onClick={() => {
        corner.value = k;
      }}
    >
      <span>
        <b class="figure">{count(of.vertex)}</b> {placeOf(of)}
      </span>
      {isShown && <small>{cause ? whyOf(cause) : isAdded(of) ? say.unknown : ""}</small>}
    </button>
  );
}

const isAdded = ({ origin }: Corner): boolean => origin === "onSegment" || origin === "free";

function placeOf({ origin, segment, segments }: Corner): string {
  const say = words.value.mesh.triangle;
  if (origin === "crossing" && segments) return say.crossing(count(segments[0]), count(segments[1]));
  if (origin === "onSegment") return segment === null ? say.onHull : say.onSegment(count(segment));
  return say.origins[origin];
}

function whyOf({ rule, by, step }: NonNullable<Corner["cause"]>): string {
  const say = words.value.mesh.triangle;
  const tooClose = by === null ? "" : ` ${say.by(count(by))}`;
  return `${say.rules[rule]}${tooClose} ${say.step(count(step))}`;
}

/** What the lines on the stage mean. */
function Legend({ cause }: { cause: Corner["cause"] }) {
  const say = words.value.mesh.legend;
  return (
    <ul class="mesh-legend quiet">
      <li class="circle">{say.circle}</li>
      {cause && cause.parent.length > 0 && <li class="parent">{say.parent}</li>}
      {cause && cause.by !== null && <li class="by">{say.by}</li>}
    </ul>
  );
}
