//! A place where the three sub-triangles have about equally many data, in floats: found by selection.
//!
//! With barycentric coordinates λ of a datum and τ of the place, the datum lies in part i if λ_i/τ_i is the least
//! of the three quotients. Given the ratio τ_1/τ_2, the data are in part 0 in the order of λ_0/min(λ_1/τ_1, λ_2/τ_2)
//! as τ_0 grows: selecting gives τ_0 such that part 0 has its third. As the ratio grows, and τ_0 with it, part 2 loses
//! data and never gains any: bisection gives the ratio.
//!
//! *Cost*: O(m) for each of the halvings, of which there are about log m if data are not in tiny clusters, and
//! never more than [`MOST_HALVINGS`].
//!
//! *Does not* decide anything: numbers are rounded, and of data on a line through a corner it does not see that they
//! can be on both sides. Whoever uses a place tests it.

use crate::Point;

/// Enough for all ratios that occur, and to tell neighbouring numbers apart.
const MOST_HALVINGS: usize = 72;

/// Finds barycentric coordinates of such a place, up to a factor; or of one that comes close, and of one where
/// data on lines to corner 0 are in the way.
pub(super) fn weights(corners: [Point; 3], data: &[Point], least: usize) -> Vec<[f64; 3]> {
    let frame = Frame::new(corners);
    let data: Vec<_> = data.iter().map(|&p| frame.coordinates(p)).collect();
    let mut search = Search::new(&data);
    // Halfway between what must be and what would be best.
    let goal = least.midpoint(data.len() / 3);
    let (mut low, mut high) = search.ratios();
    let [mut best, mut last] = [Split::default(); 2];
    for _ in 0..MOST_HALVINGS {
        let ratio = low.sqrt() * high.sqrt();
        last = search.split(ratio);
        if last.fewest() >= goal {
            return vec![last.weights];
        }
        if last.fewest() > best.fewest() {
            best = last;
        }
        if !(low < ratio && ratio < high) {
            break;
        }
        match last.counts[2] > data.len() / 3 {
            true => low = ratio,
            false => high = ratio,
        }
    }
    vec![best.weights, last.weights]
}

/// Returns the point with barycentric coordinates that are proportional to `weights`, rounded.
pub(super) fn place(corners: [Point; 3], weights: [f64; 3]) -> Point {
    let largest = weights.into_iter().fold(0.0, f64::max);
    let scaled = weights.map(|w| w / largest);
    let sum: f64 = scaled.iter().sum();
    let shares = scaled.map(|w| w / sum);
    let mixed = |[a, b, c]: [f64; 3]| {
        // Relative to a corner, so that a place in a small triangle far from the origin is rounded but once.
        let relative = a + ((b - a) * shares[1] + (c - a) * shares[2]);
        match relative.is_finite() {
            true => relative,
            false => a * shares[0] + b * shares[1] + c * shares[2],
        }
    };
    Point::new(mixed(corners.map(|p| p.x)), mixed(corners.map(|p| p.y)))
}

/// How ratios are divided.
#[derive(Clone, Copy, Default)]
struct Split {
    weights: [f64; 3],
    counts: [usize; 3],
}

impl Split {
    fn fewest(&self) -> usize {
        self.counts.into_iter().fold(usize::MAX, usize::min)
    }
}

/// Data, and room for a number of each.
struct Search<'d> {
    data: &'d [[f64; 3]],
    keys: Vec<f64>,
}

impl<'d> Search<'d> {
    fn new(data: &'d [[f64; 3]]) -> Self {
        let keys = vec![0.0; data.len()];
        Self { data, keys }
    }

    /// Returns bounds for the ratio of the second coordinate to the third.
    fn ratios(&self) -> (f64, f64) {
        let ratios = self.data.iter().map(|[_, b, c]| b / c);
        let useful = ratios.filter(|r| (1e-150..1e150).contains(r));
        let (low, high) = useful.fold((f64::MAX, 0.0_f64), |(low, high), r| {
            (low.min(r), high.max(r))
        });
        // A little more, so that the outermost are inside.
        match low <= high {
            true => (low / 4.0, high * 4.0),
            false => (0.25, 4.0),
        }
    }

    /// Chooses the first coordinate such that part 0 has a third, the ratio of the others being given.
    fn split(&mut self, ratio: f64) -> Split {
        let key = |&[a, b, c]: &[f64; 3]| match (b / ratio).min(c) {
            0.0 => f64::INFINITY,
            other => a / other,
        };
        let keys = self.keys.iter_mut().zip(self.data);
        keys.for_each(|(slot, datum)| *slot = key(datum));
        let first = self.cut();
        let mut split = Split {
            weights: [first, ratio, 1.0],
            counts: [0; 3],
        };
        for datum @ [_, b, c] in self.data {
            let part = match key(datum) < first {
                true => 0,
                false => 1 + usize::from(*c < b / ratio),
            };
            split.counts[part] += 1;
        }
        split
    }

    /// Returns a number that a third of the keys are below, or as many as can be.
    fn cut(&mut self) -> f64 {
        let third = self.keys.len() / 3;
        if third == 0 {
            return 1.0;
        }
        let (below, &mut above, rest) = self.keys.select_nth_unstable_by(third, f64::total_cmp);
        let last = below.iter().copied().fold(0.0, f64::max);
        if last < above {
            return midway(last, above);
        }
        // Equal keys: none of them, or all.
        let lower = below.iter().copied().filter(|&key| key < above);
        let higher = rest.iter().copied().filter(|&key| key > above);
        let fewer = lower.clone().count();
        let more = self.data.len() - higher.clone().count();
        match third - fewer < more - third && fewer > 0 {
            true => midway(lower.fold(0.0, f64::max), above),
            false => midway(above, higher.fold(f64::INFINITY, f64::min)),
        }
    }
}

/// A number between two that are not negative, of which the first is finite unless both are infinite.
fn midway(low: f64, high: f64) -> f64 {
    if high.is_finite() {
        low / 2.0 + high / 2.0
    } else if low == 0.0 {
        1.0
    } else {
        (2.0 * low).min(f64::MAX)
    }
}

/// Coordinates in which a triangle is about as large as 1, in both directions.
struct Frame {
    corners: [Point; 3],
    /// Applied first, so that differences do not overflow: 1 for all but huge coordinates.
    shrink: f64,
    scale: [f64; 2],
}

impl Frame {
    fn new(corners: [Point; 3]) -> Self {
        let axes = [corners.map(|p| p.x), corners.map(|p| p.y)];
        let is_huge = axes.as_flattened().iter().any(|c| c.abs() > 1e300);
        let shrink = if is_huge { 0.0625 } else { 1.0 };
        let scale = axes.map(|coordinates| {
            let [a, b, c] = coordinates.map(|c| c * shrink);
            let size = a.max(b).max(c) - a.min(b).min(c);
            // 2^−e for a size of 2^e and more; e is −1022 at least, and far from 1023.
            let biased = size.max(f64::MIN_POSITIVE).to_bits() >> 52;
            f64::from_bits((2046 - biased) << 52)
        });
        Self {
            corners,
            shrink,
            scale,
        }
    }

    /// Returns barycentric coordinates, up to a factor that is the same for all points.
    fn coordinates(&self, p: Point) -> [f64; 3] {
        let shrink = self.shrink;
        let [a, b, c] = self.corners.map(|corner| {
            let x = corner.x * shrink - p.x * shrink;
            let y = corner.y * shrink - p.y * shrink;
            [x * self.scale[0], y * self.scale[1]]
        });
        let area = |[ux, uy]: [f64; 2], [vx, vy]: [f64; 2]| (ux * vy - uy * vx).max(0.0);
        [area(b, c), area(c, a), area(a, b)]
    }
}
