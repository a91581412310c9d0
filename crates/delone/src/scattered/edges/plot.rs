//! A triangle, or a quadrilateral of two, that is to be divided by a vertex on a segment in it.
//!
//! ```text
//!           c            c            Corners c, a, d, b, counter-clockwise; of a triangle with an outer edge
//!          /|\          /|\           ab they are c, a, b. The segment is ab, or the other diagonal cd.
//!         / | \        / | \          Part k lies between corners k and k + 1: 0 is avc, 1 adv, 2 dbv,
//!        / 0|3 \      / 0|1 \         3 vbc; in the triangle 0 is avc and 1 is vbc.
//!       a --v-- b    a --v-- b
//!        \ 1|2 /
//!         \ | /
//!           d
//! ```

use super::super::share::Parts;
use super::rounding::outward;
use crate::Point;
use crate::predicates::{Orientation, orient2d, point_between};

/// What is to be divided, and along which segment.
pub(in super::super) struct Plot<'d> {
    corners: [Point; 4],
    layout: &'static Layout,
    /// Its data, each of which lies in it.
    pub(super) data: &'d [Point],
}

/// How parts and segment are made of corners.
struct Layout {
    /// Between which corners each part lies.
    parts: &'static [[usize; 2]],
    /// Where the segment starts and ends.
    ends: [usize; 2],
    /// The parts that have the start as a corner; the others have the end.
    at_start: Parts,
    /// The corner to the left of the segment, and that to the right if there is one.
    far: &'static [usize],
}

const QUARTERS: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 3], [3, 0]];

static OUTER: Layout = Layout {
    parts: &[[0, 1], [2, 0]],
    ends: [1, 2],
    at_start: 0b01,
    far: &[0],
};

static EDGE: Layout = Layout {
    parts: QUARTERS,
    ends: [1, 3],
    at_start: 0b0011,
    far: &[0, 2],
};

static DIAGONAL: Layout = Layout {
    parts: QUARTERS,
    ends: [0, 2],
    at_start: 0b1001,
    far: &[3, 1],
};

/// What the parts would hold if a vertex were at some place.
pub(super) struct Tally {
    /// In which parts each datum may be.
    pub options: Vec<Parts>,
    /// How many may be in each; 0 beyond the last part.
    pub counts: [usize; 4],
}

impl<'d> Plot<'d> {
    /// A triangle `abc` whose edge ab is an outer one.
    pub fn outer([a, b, c]: [Point; 3], data: &'d [Point]) -> Self {
        let (corners, layout) = ([c, a, b, b], &OUTER);
        Self {
            corners,
            layout,
            data,
        }
    }

    /// A quadrilateral of triangles `abc` and bad, along their common edge.
    pub fn edge([a, b, c, d]: [Point; 4], data: &'d [Point]) -> Self {
        let (corners, layout) = ([c, a, d, b], &EDGE);
        Self {
            corners,
            layout,
            data,
        }
    }

    /// The same along its other diagonal, from c to d; it must be strictly convex.
    pub fn diagonal([a, b, c, d]: [Point; 4], data: &'d [Point]) -> Self {
        let (corners, layout) = ([c, a, d, b], &DIAGONAL);
        Self {
            corners,
            layout,
            data,
        }
    }

    /// Into how many parts it is divided.
    pub(super) fn num_parts(&self) -> usize {
        self.layout.parts.len()
    }

    /// The parts at the start of the segment.
    pub(super) fn at_start(&self) -> Parts {
        self.layout.at_start
    }

    /// Where the segment starts and ends.
    pub(super) fn segment(&self) -> [Point; 2] {
        self.layout.ends.map(|k| self.corners[k])
    }

    /// The corner to the left of the segment, and that to the right, if there is one.
    pub(super) fn far_corners(&self) -> impl Iterator<Item = Point> + '_ {
        self.layout.far.iter().map(|&k| self.corners[k])
    }

    /// The point that stands for place `b` on the segment, 0 at its start and 1 at its end; `None` if that is an end,
    /// or no point will do.
    pub(super) fn place(&self, b: f64) -> Option<Point> {
        let [start, end] = self.segment();
        let t = point_between([start, end], b);
        let t = match self.num_parts() {
            2 => outward([start, end], t)?,
            _ => t,
        };
        (t != start && t != end).then_some(t)
    }

    /// Tells which parts are triangles, strictly counter-clockwise, if the vertex is at `t`.
    fn proper(&self, t: Point) -> impl Iterator<Item = bool> + '_ {
        let parts = self.layout.parts.iter();
        let ends = parts.map(|part| part.map(|k| self.corners[k]));
        ends.map(move |[from, to]| orient2d(from, to, t) == Orientation::Left)
    }

    /// Tells whether all are.
    pub(super) fn is_proper(&self, t: Point) -> bool {
        self.proper(t).all(|is_proper| is_proper)
    }

    /// Counts what the parts would hold with a vertex at `t`, boundaries included. A part that is no triangle, because
    /// `t` is rounded, holds nothing.
    ///
    /// *Exact*: by the signs at `t` as it is.
    ///
    /// *Cost*: an orientation test for each corner and datum.
    pub(super) fn tally(&self, t: Point) -> Tally {
        let proper = self.proper(t).enumerate();
        let proper = proper.fold(0, |all, (k, is_proper)| all | Parts::from(is_proper) << k);
        let options = self.data.iter().map(|&p| self.options(t, p) & proper);
        let options: Vec<_> = options.collect();
        let mut counts = [0; 4];
        for &parts in &options {
            for (k, count) in counts.iter_mut().enumerate() {
                *count += usize::from(parts >> k & 1);
            }
        }
        Tally { options, counts }
    }

    /// The parts in which `p` may be: those between whose two spokes it lies, seen from `t`.
    ///
    /// All parts together are the plot, which contains `p` and is star-shaped about `t`, so this is enough.
    fn options(&self, t: Point, p: Point) -> Parts {
        let spokes = self.corners.map(|corner| orient2d(t, corner, p));
        let parts = self.layout.parts.iter().enumerate();
        parts.fold(0, |options, (k, &[from, to])| {
            let is_in = spokes[from] != Orientation::Right && spokes[to] != Orientation::Left;
            options | Parts::from(is_in) << k
        })
    }
}
