//! What whoever watches sees, as sets: whatever changes at once is told as their difference.
//!
//! *Cost*: O(n log n); made only if anybody watches.

use crate::constrained::Steiner;
use crate::observe::{ascending, smallest_first};
use crate::{ConstrainedTriangulation, Event, Observer, Point, VertexId};
use std::collections::BTreeSet;

/// Vertices, segments and triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Picture {
    num_points: usize,
    /// Smaller end first.
    segments: BTreeSet<[VertexId; 2]>,
    /// Segments and sides of triangles, smaller end first.
    edges: BTreeSet<[VertexId; 2]>,
    /// Smallest corner first.
    triangles: BTreeSet<[VertexId; 3]>,
}

impl Picture {
    /// So many points, and nothing between them.
    pub fn of_points(num_points: usize) -> Self {
        Self {
            num_points,
            ..Self::default()
        }
    }

    /// The points and segments of a domain, once those are divided.
    pub fn of_segments(t: &ConstrainedTriangulation, steiner: &Steiner) -> Self {
        let num_points = t.triangulation().points().len();
        let mut segments: BTreeSet<_> = t.constrained_edges().map(ascending).collect();
        for (v, halved) in (num_points..).map(VertexId::new).zip(&steiner.halved) {
            if let Some([a, b]) = *halved {
                segments.remove(&ascending([a, b]));
                segments.extend([[a, v], [v, b]].map(ascending));
            }
        }
        Self {
            num_points: num_points + steiner.points.len(),
            edges: segments.clone(),
            segments,
            triangles: BTreeSet::new(),
        }
    }

    /// A mesh with its segments.
    pub fn of_mesh(t: &ConstrainedTriangulation) -> Self {
        let corners = t.triangulation().triangles().iter().copied();
        let mut picture = Self::of_segments(t, &Steiner::default()).with(corners);
        // If all points lie on one line, there are edges without triangles.
        picture
            .edges
            .extend(t.triangulation().edges().map(ascending));
        picture
    }

    /// What is seen of faces: their corners, of which bits say that the edge opposite is a segment, and whether they
    /// are outside. Those are not seen, but for their segments.
    pub fn of_faces(
        num_points: usize,
        faces: impl Iterator<Item = ([VertexId; 3], u8, bool)>,
    ) -> Self {
        let mut picture = Self::of_points(num_points);
        for (corners @ [a, b, c], bits, is_outside) in faces {
            let sides = [[b, c], [c, a], [a, b]].map(ascending);
            let segments = (0..3).filter(|k| bits >> k & 1 == 1).map(|k| sides[k]);
            picture.segments.extend(segments.clone());
            picture.edges.extend(segments);
            if !is_outside {
                picture = picture.with([corners]);
            }
        }
        picture
    }

    /// What two pictures have in common, but for what hangs on vertex `v`.
    pub fn common(&self, other: &Self, v: VertexId) -> Self {
        let edges = |ours: &BTreeSet<_>, theirs: &BTreeSet<_>| {
            let both = ours.intersection(theirs).copied();
            both.filter(|edge: &[VertexId; 2]| !edge.contains(&v))
                .collect()
        };
        let both = self.triangles.intersection(&other.triangles).copied();
        Self {
            num_points: self.num_points,
            segments: edges(&self.segments, &other.segments),
            edges: edges(&self.edges, &other.edges),
            triangles: both.filter(|corners| !corners.contains(&v)).collect(),
        }
    }

    /// Adds triangles and their sides.
    pub fn with(mut self, triangles: impl IntoIterator<Item = [VertexId; 3]>) -> Self {
        for [a, b, c] in triangles {
            self.edges.extend([[a, b], [b, c], [c, a]].map(ascending));
            self.triangles.insert(smallest_first([a, b, c]));
        }
        self
    }

    /// Tells whether there is a triangle.
    pub fn has_triangles(&self) -> bool {
        !self.triangles.is_empty()
    }

    /// Turns this picture into another, and tells of all that changes; `points` are those of both.
    pub fn turn_into(
        &mut self,
        to: Self,
        points: &[Point],
        line: u16,
        observer: &mut impl Observer,
    ) {
        self.tell_change(&to, points, |event| observer.tell(line, || event));
        *self = to;
    }

    fn tell_change(&self, to: &Self, points: &[Point], mut tell: impl FnMut(Event)) {
        for &triangle in self.triangles.difference(&to.triangles) {
            tell(Event::TriangleDeleted { triangle });
        }
        for &edge in self.segments.difference(&to.segments) {
            tell(Event::EdgeUnlocked { edge });
        }
        for &edge in self.edges.difference(&to.edges) {
            tell(Event::EdgeDeleted { edge });
        }
        let numbered = |i: usize| (VertexId::new(i), points[i]);
        for (vertex, at) in (to.num_points..self.num_points).rev().map(numbered) {
            tell(Event::VertexDeleted { vertex, at });
        }
        for (vertex, at) in (self.num_points..to.num_points).map(numbered) {
            tell(Event::VertexCreated { vertex, at });
        }
        for &edge in to.edges.difference(&self.edges) {
            tell(Event::EdgeCreated { edge });
        }
        for &edge in to.segments.difference(&self.segments) {
            tell(Event::EdgeLocked { edge });
        }
        for &triangle in to.triangles.difference(&self.triangles) {
            tell(Event::TriangleCreated { triangle });
        }
    }
}
