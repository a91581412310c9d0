// Selection: the smaller items to the left, the larger ones to the right. After Floyd and Rivest, "Algorithm 489: The
// algorithm SELECT – for finding the ith smallest of n elements", 1975. Linear on average, equal items or not.

/** Ranges longer than this are first narrowed down by a sample. */
const LONG = 600;

/**
 * Orders items `left` to `right` such that no key before place `k` is larger than the one there, and none behind it
 * smaller. `other` and `items` are moved along.
 */
export function select(
  keys: Float64Array,
  other: Float64Array,
  items: Uint32Array,
  k: number,
  left: number,
  right: number,
): void {
  while (right > left) {
    if (right - left > LONG) {
      const [from, to] = sample(k, left, right);
      select(keys, other, items, k, from, to);
    }
    const middle = part(keys, other, items, k, left, right);
    if (middle <= k) left = middle + 1;
    if (k <= middle) right = middle - 1;
  }
}

/** Returns the range around place `k` in which a sample most likely has the key that belongs there. */
function sample(k: number, left: number, right: number): [number, number] {
  const count = right - left + 1;
  const rank = k - left + 1;
  const log = Math.log(count);
  const size = 0.5 * Math.exp((2 * log) / 3);
  const spread = 0.5 * Math.sqrt((log * size * (count - size)) / count) * Math.sign(rank - count / 2);
  return [
    Math.max(left, Math.floor(k - (rank * size) / count + spread)),
    Math.min(right, Math.floor(k + ((count - rank) * size) / count + spread)),
  ];
}

/** Parts a range by the key at place `k`, and returns the place where that key is then. */
function part(
  keys: Float64Array,
  other: Float64Array,
  items: Uint32Array,
  k: number,
  left: number,
  right: number,
): number {
  const key = keys[k];
  let [i, j] = [left, right];
  swap(keys, other, items, left, k);
  if (keys[right] > key) swap(keys, other, items, left, right);
  while (i < j) {
    swap(keys, other, items, i, j);
    i++;
    j--;
    while (keys[i] < key) i++;
    while (keys[j] > key) j--;
  }
  if (keys[left] === key) swap(keys, other, items, left, j);
  else {
    j++;
    swap(keys, other, items, j, right);
  }
  return j;
}

function swap(keys: Float64Array, other: Float64Array, items: Uint32Array, i: number, j: number): void {
  const key = keys[i];
  keys[i] = keys[j];
  keys[j] = key;
  const along = other[i];
  other[i] = other[j];
  other[j] = along;
  const item = items[i];
  items[i] = items[j];
  items[j] = item;
}
