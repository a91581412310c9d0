//! Watching an algorithm at work, step by step: for lessons, pictures and tests.
//!
//! Where a [`Watch`](crate::Watch) learns how far work has come, an observer learns what is done. The
//! words are those of all algorithms that can be followed: each uses some of them, in an order of its own.
//!
//! [`Strategy::Thesis`](crate::Strategy::Thesis) divides segments ([`Event::EdgeSplit`]), then bisects longest
//! edges: an `EdgeSplit`, followed by an [`Event::Examined`] for every edge looked at again, which is followed by an
//! [`Event::Flipped`] if that edge was flipped. Then it opens triangles: [`Event::Skinniest`], how
//! ([`Event::OpenedByBisection`] or [`Event::OpenedByCircumcenter`]), the `EdgeSplit` or
//! [`Event::TriangleSplit`], and flips as before. [`Event::StageEnded`] closes each part, if it came to
//! its end, and [`Event::TakenBack`] the whole, if it did not end well. Vertices have the numbers of the result.
//!
//! *Cost*: the compiler removes what nobody observes.

use crate::{Angle, Point, VertexId};

/// A step of an algorithm. Edges and triangles are named by their vertices, triangles counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// An edge is looked at: is it locally Delaunay?
    Examined {
        /// Its ends.
        edge: [VertexId; 2],
    },
    /// It was not: the other diagonal of its quadrilateral takes its place.
    Flipped {
        /// The ends of the edge that goes.
        from: [VertexId; 2],
        /// The ends of the one that comes.
        to: [VertexId; 2],
    },
    /// A new vertex divides an edge, and is joined to the corners opposite.
    EdgeSplit {
        /// The ends of the edge.
        edge: [VertexId; 2],
        /// The new vertex.
        vertex: VertexId,
        /// Where it lies.
        at: Point,
    },
    /// A new vertex in a triangle is joined to its corners.
    TriangleSplit {
        /// The corners of the triangle.
        triangle: [VertexId; 3],
        /// The new vertex.
        vertex: VertexId,
        /// Where it lies.
        at: Point,
    },
    /// This triangle is the next to be improved: of all skinny ones none has a smaller angle.
    Skinniest {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// How it is opened has been decided: by bisecting this edge.
    OpenedByBisection {
        /// The ends of the edge.
        edge: [VertexId; 2],
    },
    /// How it is opened has been decided: by the circumcenter of this triangle.
    OpenedByCircumcenter {
        /// Its corners.
        triangle: [VertexId; 3],
    },
    /// A part of the work is done.
    StageEnded {
        /// Which.
        stage: Stage,
        /// The smallest angle of the mesh, as far as it is known then.
        min_angle: Option<Angle>,
    },
    /// The work has not come to a good end: all vertices from this one on are taken back.
    TakenBack {
        /// The first vertex that goes.
        from: VertexId,
    },
}

/// A part of an algorithm's work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// Segments are divided evenly, before there is a mesh.
    SplitEdges,
    /// Longest edges are bisected.
    ShortenEdges,
    /// Skinny triangles are opened.
    OpenTriangles,
}

/// Someone who is told each step.
///
/// ```
/// use delone::{Angle, DomainRule, Event, Observer, Pslg, Quality, Refinement, Strategy};
///
/// #[derive(Default)]
/// struct Flips(usize);
/// impl Observer for Flips {
///     fn observe(&mut self, event: Event) {
///         self.0 += usize::from(matches!(event, Event::Flipped { .. }));
///     }
/// }
///
/// let mut outline = Pslg::from_points([(0.0, 0.0), (9.0, 0.0), (7.0, 2.0), (0.0, 1.0)]);
/// outline.add_ring([0, 1, 2, 3]);
/// let quality = Quality { max_edge: Some(1.0), ..Quality::default() };
/// let thesis = Refinement::new(quality).domain(DomainRule::Carve).strategy(Strategy::Thesis);
/// let mut flips = Flips::default();
/// thesis.observe(outline, &mut flips)?;
/// assert!(flips.0 > 0);
/// # Ok::<(), delone::Error>(())
/// ```
pub trait Observer {
    /// Told of a step that has just been taken or, of an opening, is about to be.
    fn observe(&mut self, event: Event);
}

/// Observes nothing, at no cost.
impl Observer for () {
    #[inline]
    fn observe(&mut self, _: Event) {}
}
