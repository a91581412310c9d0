// What is asked of a mesh, and what came of it.

import type { MeshKind } from "../engine/protocol";
import { build, kind, mesh, options } from "../state/mesh";
import { number, words } from "../words";

const kinds: MeshKind[] = ["triangulate", "constrain", "refine"];

export function MeshPanel() {
  const say = words.value.mesh;
  return (
    <section aria-labelledby="mesh-heading">
      <h2 id="mesh-heading">{say.heading}</h2>
      <label class="field">
        {say.kind}
        <select
          value={kind.value}
          onChange={(event) => {
            kind.value = event.currentTarget.value as MeshKind;
          }}
        >
          {kinds.map((each) => (
            <option key={each} value={each}>
              {say.kinds[each]}
            </option>
          ))}
        </select>
      </label>
      <label class="field">
        {say.minAngle}
        <input
          type="number"
          min="0"
          max="40"
          value={options.value.minAngle}
          onChange={(event) => {
            options.value = { ...options.value, minAngle: event.currentTarget.valueAsNumber || 0 };
          }}
        />
      </label>
      <button type="button" onClick={() => void build()}>
        {say.build}
      </button>
      {mesh.value && (
        <dl>
          <dt>{say.triangles}</dt>
          <dd>{number(mesh.value.quality.triangles)}</dd>
          <dt>{say.vertices}</dt>
          <dd>{number(mesh.value.quality.vertices)}</dd>
          <dt>{say.hash}</dt>
          <dd>
            <code>{mesh.value.hash}</code>
          </dd>
        </dl>
      )}
    </section>
  );
}
