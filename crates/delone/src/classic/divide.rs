//! Divide and conquer: the builder of this library, watched at work.
//!
//! It is the same code that [`triangulate`](crate::triangulate) runs, on one thread, before a
//! [`Witness`] who puts its deeds into the words of all algorithms.

use super::{About, Input, Output, Takes};
use crate::delaunay::{Deed, Witness, triangulate_before};
use crate::order::Axis;
use crate::predicates::{in_circle, in_circle_perturbed, orient2d};
use crate::{Cut, Error, Event, Observer, Point, VertexId};
use std::sync::{Mutex, PoisonError};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "divide-and-conquer",
    title: "divide and conquer",
    source: "Guibas and Stolfi 1985; Shewchuk 1996 for triangles with ghosts",
    idea: "Cut the points in two, triangulate both sets, and knit the two triangulations together from \
           their lower common tangent upwards.",
    cost: "linear in practice, along a space-filling curve; O(n²) at worst",
    guarantees: "the canonical Delaunay triangulation",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "sort the points along a space-filling curve",
        "to triangulate a set:",
        "  up to four points: join them at once",
        "  else cut the set in two, and triangulate both",
        "  while a point of either hull lies below the line through both lowest: go down to it",
        "  let the base be the lower common tangent",
        "  repeat:",
        "    on either side, the candidate is the next vertex up the hull, if it lies above the base",
        "    as long as the vertex behind a candidate lies in the circle of base and candidate:",
        "      delete the edge from base to candidate; the vertex behind is the next",
        "    without candidates this is done",
        "    if there are two, take the one whose circle with the base does not hold the other",
        "    join it to the other end of the base: that edge is the next base",
    ],
};

/// Triangulates.
pub(super) fn run(input: &Input, observer: &mut (impl Observer + Send)) -> Result<Output, Error> {
    let points = input.pslg.points.clone();
    let t = if observer.is_watching() {
        let scribe = Scribe {
            points: &input.pslg.points,
            state: Mutex::new(State { line: 1, observer }),
        };
        triangulate_before(points, input.watch, &scribe)?
    } else {
        triangulate_before(points, input.watch, ())?
    };
    Ok(Output {
        triangles: t.triangles().to_vec(),
        duplicates: t.duplicates().to_vec(),
        points: t.points().to_vec(),
        ..Output::default()
    })
}

/// Who writes down what is done.
struct Scribe<'r, O> {
    points: &'r [Point],
    /// Nobody waits for it: there is one thread.
    state: Mutex<State<'r, O>>,
}

struct State<'r, O> {
    line: u16,
    observer: &'r mut O,
}

impl<O: Observer + Send> Witness for &Scribe<'_, O> {
    const IS_WATCHING: bool = true;

    fn tell(self, deed: Deed) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.line = line(deed).unwrap_or(state.line);
        if let Some(event) = self.event(deed) {
            let line = state.line;
            state.observer.tell(line, || event);
        }
    }
}

/// The line of pseudocode that a deed begins.
fn line(deed: Deed) -> Option<u16> {
    Some(match deed {
        Deed::Leaf => 3,
        Deed::Cut { .. } => 4,
        Deed::Tangent => 5,
        Deed::Base(_) => 6,
        Deed::Raise(_) => 8,
        Deed::Delete => 10,
        Deed::Join => 13,
        _ => return None,
    })
}

impl<O> Scribe<'_, O> {
    fn event(&self, deed: Deed) -> Option<Event> {
        Some(match deed {
            Deed::Leaf | Deed::Tangent | Deed::Delete | Deed::Join => return None,
            Deed::Cut { axis, first } => Event::SetDivided {
                cut: match axis {
                    Axis::X => Cut::Vertical(self.point(first).x),
                    Axis::Y => Cut::Horizontal(self.point(first).y),
                },
            },
            Deed::Base(edge) => Event::TangentFound { edge },
            Deed::Raise(edge) => Event::EdgeExamined { edge },
            Deed::Turn([a, b, c]) => self.turn([a, b], c),
            Deed::Circle([a, b, c, d]) => self.circle([a, b, c], d),
            Deed::EdgeCreated(edge) => Event::EdgeCreated { edge },
            Deed::EdgeDeleted(edge) => Event::EdgeDeleted { edge },
            Deed::TriangleCreated(triangle) => Event::TriangleCreated { triangle },
            Deed::TriangleDeleted(triangle) => Event::TriangleDeleted { triangle },
        })
    }

    fn turn(&self, line: [VertexId; 2], point: VertexId) -> Event {
        let [a, b] = line.map(|v| self.point(v));
        let answer = orient2d(a, b, self.point(point));
        Event::OrientationTested {
            line,
            point,
            answer,
        }
    }

    fn circle(&self, triangle: [VertexId; 3], point: VertexId) -> Event {
        let ([a, b, c], p) = (triangle.map(|v| self.point(v)), self.point(point));
        Event::CircleTested {
            triangle,
            point,
            answer: in_circle(a, b, c, p),
            is_inside: in_circle_perturbed(a, b, c, p),
        }
    }

    fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }
}
