//! Loose segments, each with two ends of its own.

use super::{Drawing, exact, loose};
use crate::Random;

const NONE: u32 = u32::MAX;

/// Scatters `count` segments of 0.2 to 1.2 mean spacings, none touching another.
///
/// Each is drawn at random until it meets none of those before; in the end two of three still fit.
/// Only segments whose midpoints lie closer than the longest length can meet, and those lie in the
/// nine cells around. The square is filled strip by strip, so that these stay in the cache, and the
/// segments are shuffled in the end.
///
/// *Cost*: 0.5 µs a segment.
pub fn apart(count: usize, random: &mut Random) -> Drawing {
    let spacing = spacing(count);
    let strips = (1.0 / (16.0 * spacing)).ceil();
    // A little wider than the longest segment, for ends are rounded.
    let mut cells = Cells::new(1.25 * spacing);
    let mut segments: Vec<[[f64; 2]; 2]> = Vec::with_capacity(count);
    while segments.len() < count {
        let strip = (segments.len() as f64 * strips / count as f64).floor();
        let middle = [random.unit(), (strip + random.unit()) / strips];
        let Some(segment) = draw_inside(middle, [0.2 * spacing, 1.2 * spacing], random) else {
            continue;
        };
        let meets = |i: usize| exact::meet(segments[i], segment);
        if !cells.around(middle).any(meets) {
            cells.push(middle);
            segments.push(segment);
        }
    }
    random.shuffle(&mut segments);
    loose(segments)
}

/// Joins `count` pairs of random points.
pub fn across(count: usize, random: &mut Random) -> Drawing {
    let mut point = || [random.unit(), random.unit()];
    loose((0..count).map(|_| [point(), point()]).collect())
}

/// Scatters `count` segments of 2 to 6 mean spacings, wherever they cross.
///
/// Two segments of mean length l at random places of a unit square cross with probability 2 l² / π:
/// with l = 4 / √n that makes 16 n / π crossings, or some more as all of them lie inside.
pub fn tangled(count: usize, random: &mut Random) -> Drawing {
    let spacing = spacing(count);
    let lengths = [2.0 * spacing, 6.0 * spacing].map(|length| length.min(0.9));
    let segments = std::iter::repeat_with(|| {
        let middle = [random.unit(), random.unit()];
        draw_inside(middle, lengths, random)
    });
    loose(segments.flatten().take(count).collect())
}

fn spacing(count: usize) -> f64 {
    1.0 / (count.max(1) as f64).sqrt()
}

/// Draws direction and length of a segment about `middle`, unless it reaches out of the unit square.
fn draw_inside(
    middle: [f64; 2],
    [shortest, longest]: [f64; 2],
    random: &mut Random,
) -> Option<[[f64; 2]; 2]> {
    let length = random.between(shortest, longest);
    let half = random.on_circle(length / 2.0);
    let end = |sign: f64| [0, 1].map(|k| exact::snap(middle[k] + sign * half[k]));
    let ends = [end(-1.0), end(1.0)];
    let inside = ends.as_flattened().iter().all(|c| (0.0..1.0).contains(c));
    inside.then_some(ends)
}

/// Square cells over the unit square, each with the list of the midpoints in it.
struct Cells {
    /// How many in a row.
    side: usize,
    /// For each cell the item that was pushed last.
    last: Vec<u32>,
    /// For each item the one before it in its cell.
    before: Vec<u32>,
}

impl Cells {
    /// Makes cells at least `width` wide.
    fn new(width: f64) -> Self {
        let side = ((1.0 / width) as usize).max(1);
        Self {
            side,
            last: vec![NONE; side * side],
            before: Vec::new(),
        }
    }

    fn place(&self, point: [f64; 2]) -> [usize; 2] {
        point.map(|c| ((c * self.side as f64) as usize).min(self.side - 1))
    }

    fn push(&mut self, point: [f64; 2]) {
        let [column, row] = self.place(point);
        let last = &mut self.last[row * self.side + column];
        let item = super::index(self.before.len());
        self.before.push(std::mem::replace(last, item));
    }

    /// Visits the items in the cell of `point` and in the eight around it.
    fn around(&self, point: [f64; 2]) -> impl Iterator<Item = usize> + '_ {
        let [columns, rows] = self
            .place(point)
            .map(|c| c.saturating_sub(1)..(c + 2).min(self.side));
        let cells = rows.flat_map(move |row| columns.clone().map(move |c| row * self.side + c));
        cells.flat_map(move |cell| {
            let known = |item: u32| (item != NONE).then_some(item as usize);
            std::iter::successors(known(self.last[cell]), move |&i| known(self.before[i]))
        })
    }
}
