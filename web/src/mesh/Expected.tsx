// How many triangles will come.

import { number, words } from "../words";
import { MANY } from "./estimate";
import { expected } from "./sizes";

export function Expected() {
  const say = words.value.mesh;
  const count = expected.value;
  if (count === null) return <p class="quiet mesh-small">{say.expectedNone}</p>;
  if (count > MANY) return <p class="mesh-warning mesh-small">{say.expectedMany(number(count, 2))}</p>;
  return <p class="quiet mesh-small">{say.expected(number(count, 2))}</p>;
}
