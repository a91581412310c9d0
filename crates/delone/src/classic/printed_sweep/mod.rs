//! The plane sweep of the thesis as it is printed, with the segments in its test of visibility: a replay that
//! says where it goes wrong.
//!
//! Each point is joined to the front vertices that it sees, past segments and earlier edges. That makes all
//! tables of the thesis; but a point may see a single vertex, several runs of them, or none, and then segments
//! get lost: on about one in nine random simple polygons. [`Sweep`](super::Algorithm::Sweep) is the mended one.
//!
//! *Corrected here*, since the examples demand it: where a point sees all vertices of the front, the run
//! begins and ends at the edge between the helpers. The print cuts its array wherever it happens to begin,
//! and emits a reversed triangle. So of several runs, too, the replay takes the longest one, the first of equals; the
//! print sometimes takes one around the helpers, hidden vertices included. Signs are exact, and for equal
//! abscissas points between are seen, which the printed code misses.
//!
//! *Not corrected*: the edge from a spike to the next vertex of the front is part of a triangle later, but never
//! entered among the edges that block sight.
//!
//! *Cost*: O(n) for each test, O(n³) at worst.

mod aftermath;
mod front;
#[cfg(test)]
mod tests;

use super::sweep::helper_places;
use super::swept::Swept;
use super::{About, Board, Input, Output, Takes, ascending, sides};
use crate::Failure;
use crate::pslg::input::check;
use crate::{DomainRule, Error, Event, Observer, Point, VertexId};
use std::collections::BTreeSet;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "printed-sweep",
    title: "plane sweep as printed, segments in the test of visibility",
    source: "Thesis on refinement, Ulm 2012, programs 1.3 to 1.8",
    idea: "Join each point, from left to right, to the vertices of the front that it sees past the \
           segments.",
    cost: "O(n³) at worst: each test of visibility looks at all edges and points",
    guarantees: "none: segments may get lost, and the hull is dented; failures are listed",
    takes: Takes::Domain,
    is_delaunay: false,
    code: &[
        "let all segments be edges",
        "place two helper points to the left of all points",
        "sort the points by x, then y",
        "join both helpers and the first point: that is the front",
        "for each further point p:",
        "  find a run of vertices on the front that p sees",
        "  for each two that follow each other in the run:",
        "    join p to both: a triangle",
        "  let p replace the vertices inside the run on the front",
        "delete the helpers, their edges and their triangles",
        "turn each clockwise triangle",
        "for each triangle:",
        "  count the ring edges that the ray from its centroid to the right crosses",
        "  if their number is even: delete the triangle",
    ],
};

/// Replays the printed sweep.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let finite = |p: &&Point| p.is_finite();
    let helpers = helper_places(input.pslg.points.iter().filter(finite).copied());
    replay(input, helpers, observer)
}

/// Replays it with helper points wherever they are, the lower one first, left of all points. Without them
/// there is no front, and no point sees anything.
fn replay(
    input: &Input,
    helpers: Option<[Point; 2]>,
    observer: &mut impl Observer,
) -> Result<Output, Error> {
    check(&input.pslg)?;
    let mut replay = Replay::new(input, observer)?;
    replay.sweep(helpers)?;
    replay.strip();
    replay.turn();
    replay.look_for_segments();
    if input.domain != DomainRule::Hull {
        replay.remove_outside()?;
    }
    Ok(replay.finish())
}

/// The tables of the print.
struct Replay<'r, O> {
    board: Board<'r, O>,
    /// Smaller end first, as all edges here.
    segments: BTreeSet<[VertexId; 2]>,
    /// What blocks sight.
    edges: BTreeSet<[VertexId; 2]>,
    /// What there is to see: edges, and sides of triangles that nobody has entered as edges.
    shown: BTreeSet<[VertexId; 2]>,
    helpers: Vec<VertexId>,
    /// The vertices, sorted by x, then y.
    order: Vec<VertexId>,
    /// From the lower helper counter-clockwise to the upper one.
    front: Vec<VertexId>,
    triangles: Vec<[VertexId; 3]>,
    failures: Vec<Failure>,
    line: Swept,
}

impl<'r, O: Observer> Replay<'r, O> {
    /// Enters the segments as edges.
    fn new(input: &Input<'r>, observer: &'r mut O) -> Result<Self, Error> {
        let (mut board, order) = Board::new(input, observer)?;
        let ends = input.pslg.segments.iter();
        let ends = ends.map(|ends| ascending(ends.map(|v| board.representative(v))));
        let segments: BTreeSet<_> = ends.filter(|[a, b]| a != b).collect();
        board.at(1);
        for &edge in &segments {
            board.tell(|| Event::EdgeCreated { edge });
            board.tell(|| Event::EdgeLocked { edge });
        }
        Ok(Self {
            board,
            edges: segments.clone(),
            shown: segments.clone(),
            segments,
            helpers: Vec::new(),
            order,
            front: Vec::new(),
            triangles: Vec::new(),
            failures: Vec::new(),
            line: Swept::default(),
        })
    }

    fn fail(&mut self, failure: Failure) {
        self.failures.push(failure);
        self.board.tell(|| Event::PrintFailed { failure });
    }

    fn finish(self) -> Output {
        Output {
            triangles: self.triangles,
            constrained: self.segments.into_iter().collect(),
            failures: self.failures,
            ..self.board.finish()
        }
    }
}

/// Returns the edges of a triangle.
fn edges(triangle: [VertexId; 3]) -> [[VertexId; 2]; 3] {
    sides(triangle).map(ascending)
}
