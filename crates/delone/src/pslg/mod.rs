//! What a user draws: a planar straight-line graph of points, segments, holes and regions, before
//! anything has been checked.
//!
//! [`Pslg`] is the input of [`ConstrainedDelaunay`](crate::ConstrainedDelaunay). Nothing about it
//! needs to be clean: points may be equal, segments may repeat, overlap, run through points and
//! cross (see [`SegmentPolicy`]).

mod boxes;
mod chains;
mod facts;
mod hash;
pub(crate) mod input;
mod listed;
mod meeting;
mod near;
mod noding;
mod pieces;
mod rings;
mod rounds;
mod search;
mod slabs;
mod sorting;
mod vertices;

pub(crate) use chains::Chains;
pub use facts::{Facts, SegmentCrossing, VertexOnSegment};
pub use hash::PslgHash;
pub(crate) use listed::First;
pub use listed::Listed;
pub(crate) use near::{Nearby, Scratch};
pub(crate) use noding::{Noding, first_crossing, node};
pub use rings::Ring;

use crate::{Point, VertexId};
use std::ops::Range;

/// Points, segments between them, and what lies between the segments.
///
/// ```
/// use delone::{ConstrainedDelaunay, DomainRule, Pslg};
///
/// let mut square = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
/// square.add_ring([0, 1, 2, 3]);
/// assert_eq!(square.segments.len(), 4);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pslg {
    /// The points, ends of segments and loose ones alike; vertex `i` of the result is point `i`.
    pub points: Vec<Point>,
    /// The segments, as indices of their ends, in any order and direction.
    pub segments: Vec<[VertexId; 2]>,
    /// For each polygon the segments that bound it, outline and holes alike, as a range of indices;
    /// each must be closed. Segments in no range bound nothing and are only kept as edges. If there
    /// are none, [`DomainRule::EvenOdd`] takes all segments together.
    pub polygons: Vec<Range<usize>>,
    /// A point in each hole: everything around it, up to the segments, is carved away.
    pub holes: Vec<Point>,
    /// Regions, each named by a point in it.
    pub regions: Vec<Region>,
}

/// A part of the domain that has a name of its own: everything around a point, up to the segments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// A point in it.
    pub at: Point,
    /// A number that goes with its triangles.
    pub attribute: f64,
    /// The largest area a triangle may have in it, for refinement; triangulation only carries it.
    pub max_area: Option<f64>,
}

/// What to do where two segments cross in a point that is no vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SegmentPolicy {
    /// Refuses, naming the lexicographically first pair of segments and where they cross.
    #[default]
    Error,
    /// Cuts both and adds a vertex there, rounded to the nearest `f64`: the canonical noding, which
    /// does not depend on the order of anything.
    Split,
}

/// Which triangles belong to the domain. Holes named by a point are carved away under every rule.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DomainRule {
    /// All of the convex hull.
    #[default]
    Hull,
    /// What the outside cannot reach without crossing a segment (the rule of Triangle's `-p`). Open
    /// polylines alone enclose nothing.
    Carve,
    /// What lies behind an odd number of segments: rings in rings are holes, islands in holes belong
    /// again. A border that is used twice counts twice. With [`Pslg::polygons`], the union of the
    /// polygons, each by its own segments; segments outside of polygons do not count.
    EvenOdd,
}

impl Pslg {
    /// Makes a graph of points alone.
    pub fn from_points<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        Self {
            points: points.into_iter().map(Into::into).collect(),
            ..Self::default()
        }
    }

    /// Adds a segment between two points.
    pub fn add_segment(&mut self, a: impl Into<VertexId>, b: impl Into<VertexId>) {
        self.segments.push([a.into(), b.into()]);
    }

    /// Adds the segments of a closed ring, the last point joined to the first.
    pub fn add_ring<V: Into<VertexId>>(&mut self, ring: impl IntoIterator<Item = V>) {
        let first = self.segments.len();
        self.add_polyline(ring);
        if let Some(&[start, _]) = self.segments.get(first)
            && let Some(&[_, end]) = self.segments.last()
        {
            self.segments.push([end, start]);
        }
    }

    /// Adds the segments of an open polyline.
    pub fn add_polyline<V: Into<VertexId>>(&mut self, line: impl IntoIterator<Item = V>) {
        let mut line = line.into_iter().map(Into::into);
        if let Some(mut from) = line.next() {
            for to in line {
                self.segments.push([from, to]);
                from = to;
            }
        }
    }
}
