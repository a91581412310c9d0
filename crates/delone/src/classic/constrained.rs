//! The constrained Delaunay triangulation of this library, watched at work.
//!
//! It is the same code that [`ConstrainedDelaunay`](crate::ConstrainedDelaunay) runs, on one thread, before a
//! [`Witness`] who puts its deeds into the words of all algorithms. How the points are triangulated
//! [another](super::divide) tells: this one begins with the result, in steps of line 0.

use super::{About, Input, Output, Takes};
use crate::constrained::{Deed, Draft, Witness, triangulate_before};
use crate::predicates::{in_circle, in_circle_perturbed, orient2d};
use crate::{Error, Event, HalfEdgeId, Observer, Point, Stage, TriangleId, VertexId};
use std::cell::RefCell;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "constrained",
    title: "constrained Delaunay triangulation",
    source: "Lee and Lin 1986; Toussaint and Avis 1982 for the sides",
    idea: "Clear the corridor of triangles that a segment runs through, make the segment an edge, triangulate both \
           sides by cutting ears, and flip what is not Delaunay; then let the outside flood in up to the segments.",
    cost: "in practice a few tests for each edge that a segment crosses; O(k log k) for k of them along curves",
    guarantees: "the canonical constrained Delaunay triangulation of the domain",
    takes: Takes::Domain,
    is_delaunay: true,
    code: &[
        "triangulate the points",
        "for each segment, those first that are edges already:",
        "  for each part ae of it, from one vertex on it to the next:",
        "    walk from a over the edges that cross it to e; if one is a constraint, two segments cross",
        "    delete the triangles on the way and the edges between them; make ae an edge",
        "    for each side: for each vertex w along it:",
        "      while the last three, u, v and w, turn left: cut off their triangle, and forget v",
        "    lock ae",
        "    while an edge of the new triangles is no constraint, and not locally Delaunay: flip it",
        "    after too many flips: triangulate the vertices of each side anew, by divide and conquer",
        "from outside, and from holes, flood all that no constraint holds back",
        "delete what lies outside of the domain",
    ],
};

/// The lines that deeds begin.
mod line {
    pub const TRIANGULATE: u16 = 1;
    pub const SEGMENT: u16 = 2;
    pub const WALK: u16 = 4;
    pub const CLEAR: u16 = 5;
    pub const EAR: u16 = 7;
    pub const LOCK: u16 = 8;
    pub const FLIP: u16 = 9;
    pub const BULK: u16 = 10;
    pub const FLOOD: u16 = 11;
    pub const DELETE: u16 = 12;
}

/// Triangulates a domain.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let pslg = input.pslg.clone();
    let t = if observer.is_watching() {
        let scribe = Scribe {
            points: &input.pslg.points,
            state: RefCell::new(State {
                line: line::TRIANGULATE,
                callers: Vec::new(),
                observer,
            }),
        };
        triangulate_before(pslg, input.domain, input.watch, &scribe)?
    } else {
        triangulate_before(pslg, input.domain, input.watch, ())?
    };
    Ok(Output::of_domain(&t))
}

/// Who writes down what is done.
struct Scribe<'r, O> {
    points: &'r [Point],
    state: RefCell<State<'r, O>>,
}

struct State<'r, O> {
    line: u16,
    /// What the caller calls each vertex of the draft.
    callers: Vec<VertexId>,
    observer: &'r mut O,
}

impl<O: Observer> Witness for &Scribe<'_, O> {
    const IS_WATCHING: bool = true;

    fn begin(self, draft: &Draft, callers: &[VertexId]) {
        self.state.borrow_mut().callers = callers.to_vec();
        self.at(0);
        for h in edges(draft) {
            self.tell(Deed::EdgeCreated(ends(draft, h)));
        }
        for t in draft.mesh.triangles() {
            self.tell(Deed::TriangleCreated(draft.mesh.corners(t)));
        }
        self.at(line::TRIANGULATE);
        self.end(Stage::Triangulation);
    }

    fn tell(self, deed: Deed) {
        if let Some(line) = self.line(deed) {
            self.at(line);
        }
        match deed {
            Deed::Inserted => self.end(Stage::InsertSegments),
            _ => self.write(self.event(deed)),
        }
    }

    fn carve(self, draft: &Draft, outside: &[bool]) {
        let is_outside = |t: TriangleId| outside[t.index()];
        self.at(line::DELETE);
        for t in draft.mesh.triangles().filter(|&t| is_outside(t)) {
            self.tell(Deed::TriangleDeleted(draft.mesh.corners(t)));
        }
        for h in edges(draft) {
            let sides = [h, draft.mesh.twin(h)].map(HalfEdgeId::triangle);
            let is_bare = sides.into_iter().all(is_outside);
            // Edges of points on a line have no triangles at all.
            let had_one = sides.iter().any(|&t| !draft.mesh.is_ghost(t));
            if is_bare && had_one && !draft.marks.is_constrained(h) {
                self.tell(Deed::EdgeDeleted(ends(draft, h)));
            }
        }
        self.end(Stage::InsideTest);
    }
}

impl<O: Observer> Scribe<'_, O> {
    fn at(&self, line: u16) {
        self.state.borrow_mut().line = line;
    }

    fn write(&self, event: Option<Event>) {
        let mut state = self.state.borrow_mut();
        if let Some(event) = event {
            let line = state.line;
            state.observer.tell(line, || event);
        }
    }

    fn end(&self, stage: Stage) {
        let min_angle = None;
        self.write(Some(Event::StageEnded { stage, min_angle }));
    }

    /// The line of pseudocode that a deed begins.
    fn line(&self, deed: Deed) -> Option<u16> {
        Some(match deed {
            Deed::Segment(_) => line::SEGMENT,
            Deed::Cross(_) => line::WALK,
            Deed::Clear => line::CLEAR,
            // The walk asks on which side of the segment vertices lie, ears for the turns of a side.
            Deed::Turn(_) if self.state.borrow().line != line::WALK => line::EAR,
            Deed::Ear => line::EAR,
            Deed::Lock(_) => line::LOCK,
            Deed::Suspect(_) => line::FLIP,
            Deed::Bulk => line::BULK,
            Deed::Reach(_) => line::FLOOD,
            _ => return None,
        })
    }

    fn event(&self, deed: Deed) -> Option<Event> {
        Some(match deed {
            Deed::Clear | Deed::Ear | Deed::Bulk | Deed::Inserted => return None,
            Deed::Segment(ends) => Event::SegmentConsidered {
                segment: self.names(ends),
            },
            Deed::Cross(ends) => Event::WalkStepped {
                edge: self.names(ends),
            },
            Deed::Turn(corners) => self.turn(self.names(corners)),
            Deed::Suspect(ends) => Event::EdgeExamined {
                edge: self.names(ends),
            },
            Deed::Circle(vertices) => self.circle(self.names(vertices)),
            Deed::Flip(from, to) => Event::EdgeFlipped {
                from: self.names(from),
                to: self.names(to),
            },
            Deed::Lock(ends) => Event::EdgeLocked {
                edge: self.names(ends),
            },
            Deed::Reach(corners) => Event::TriangleVisited {
                triangle: self.names(corners),
            },
            Deed::EdgeCreated(ends) => Event::EdgeCreated {
                edge: self.names(ends),
            },
            Deed::EdgeDeleted(ends) => Event::EdgeDeleted {
                edge: self.names(ends),
            },
            Deed::TriangleCreated(corners) => Event::TriangleCreated {
                triangle: self.names(corners),
            },
            Deed::TriangleDeleted(corners) => Event::TriangleDeleted {
                triangle: self.names(corners),
            },
        })
    }

    fn turn(&self, [a, b, c]: [VertexId; 3]) -> Event {
        let [p, q, r] = [a, b, c].map(|v| self.points[v.index()]);
        Event::OrientationTested {
            line: [a, b],
            point: c,
            answer: orient2d(p, q, r),
        }
    }

    fn circle(&self, [a, b, c, d]: [VertexId; 4]) -> Event {
        let [p, q, r, s] = [a, b, c, d].map(|v| self.points[v.index()]);
        Event::CircleTested {
            triangle: [a, b, c],
            point: d,
            answer: in_circle(p, q, r, s),
            is_inside: in_circle_perturbed(p, q, r, s),
        }
    }

    fn names<const N: usize>(&self, vertices: [VertexId; N]) -> [VertexId; N] {
        let state = self.state.borrow();
        vertices.map(|v| state.callers[v.index()])
    }
}

/// Lists the edges with no end at infinity, each as one of its half-edges.
fn edges(draft: &Draft) -> impl Iterator<Item = HalfEdgeId> + '_ {
    let once = draft.mesh.half_edges();
    once.filter(|&h| h < draft.mesh.twin(h) && ends(draft, h).iter().all(|v| !v.is_infinite()))
}

fn ends(draft: &Draft, h: HalfEdgeId) -> [VertexId; 2] {
    [draft.mesh.origin(h), draft.mesh.dest(h)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::classic::Algorithm;
    use crate::{Log, Pslg};

    /// Within these tests corridors of an even number of triangles are always filled in bulk.
    #[test]
    fn what_is_filled_in_bulk_can_be_played() {
        let points = (0..160u32).map(|i| (f64::from(i * 37 % 163), f64::from(i * i % 157)));
        let mut pslg = Pslg::from_points(points);
        (1..160u32).for_each(|i| pslg.add_segment(0, i));
        let mut log = Log::new("constrained", pslg.points.clone());
        let output = Algorithm::Constrained.observe(&Input::from_pslg(pslg), &mut log);
        let scene = log.last_scene().expect("what is told can be played");
        assert_eq!(scene.hash(), output.expect("a domain").hash());
        assert!(log.steps.iter().any(|step| step.line == line::BULK));
    }

    #[test]
    fn lines_are_where_they_are_said_to_be() {
        for (line, word) in [
            (line::TRIANGULATE, "triangulate the points"),
            (line::SEGMENT, "for each segment"),
            (line::WALK, "walk"),
            (line::CLEAR, "delete the triangles"),
            (line::EAR, "turn left"),
            (line::LOCK, "lock"),
            (line::FLIP, "flip it"),
            (line::BULK, "anew"),
            (line::FLOOD, "flood"),
            (line::DELETE, "delete what lies outside"),
        ] {
            let text = ABOUT.code[usize::from(line) - 1];
            assert!(text.contains(word), "line {line} is: {text}");
        }
    }
}
