//! One side of a corridor: the path of edges that bounds it, and how it is filled with triangles.

use super::draft::{Draft, Mark};
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, TriangleId, VertexId};

/// The edges along one side of a corridor, in the order in which the segment passes them.
#[derive(Default)]
pub(super) struct Side {
    rim: Vec<RimEdge>,
    /// The edges whose other side has not turned up on this rim, as a stack.
    open: Vec<u32>,
    scan: Vec<Corner>,
}

/// An edge between the corridor and what stays.
struct RimEdge {
    /// Its half-edge in the corridor as it was.
    within: HalfEdgeId,
    /// Where that half-edge ended.
    to: VertexId,
    beyond: Beyond,
    mark: Mark,
}

/// What lies beyond an edge of the rim.
#[derive(Clone, Copy)]
enum Beyond {
    /// This half-edge, which stays or has been built.
    Stays(HalfEdgeId),
    /// The corridor itself: the edge has both sides on the rim, the other one at this index.
    Rim(u32),
}

/// A corner of the path that is left while ears are cut.
struct Corner {
    vertex: VertexId,
    /// The edge from the corner before.
    arrival: Arrival,
}

#[derive(Clone, Copy)]
enum Arrival {
    /// The first corner has none.
    Start,
    /// An edge of the rim, by index.
    Rim(u32),
    /// The edge that cut an ear off, as the half-edge in that ear.
    Cut(HalfEdgeId),
}

impl Side {
    pub fn clear(&mut self) {
        self.rim.clear();
        self.open.clear();
    }

    /// Adds the edge of half-edge `within`, which belongs to a triangle of the corridor.
    ///
    /// An edge that ends in the corridor is passed on both sides. Such edges nest like parentheses, so
    /// the other side is the last one still open.
    #[inline]
    pub fn push(&mut self, draft: &Draft, within: HalfEdgeId) {
        let index = self.rim.len() as u32;
        let twin = draft.mesh.twin(within);
        let other = self.open.last().copied();
        let beyond = match other.filter(|&i| self.rim[i as usize].within == twin) {
            Some(other) => {
                self.open.pop();
                self.rim[other as usize].beyond = Beyond::Rim(index);
                Beyond::Rim(other)
            }
            None => {
                self.open.push(index);
                Beyond::Stays(twin)
            }
        };
        self.rim.push(RimEdge {
            within,
            to: draft.mesh.dest(within),
            beyond,
            mark: draft.marks.get(within),
        });
    }

    /// Fills the side with triangles, in faces taken from `faces`, and returns the half-edge of the
    /// segment in them, whose twin is still to be bonded.
    ///
    /// Counter-clockwise the path begins at `start` and follows the rim, backwards with `REVERSED`.
    /// The new edges are added to `suspects`: they may not be Delaunay.
    pub fn fill<const REVERSED: bool>(
        &mut self,
        start: VertexId,
        draft: &mut Draft,
        faces: &mut Vec<TriangleId>,
        suspects: &mut Vec<HalfEdgeId>,
    ) -> HalfEdgeId {
        self.scan.clear();
        self.scan.push(Corner {
            vertex: start,
            arrival: Arrival::Start,
        });
        for i in 0..self.rim.len() {
            let index = if REVERSED { self.rim.len() - 1 - i } else { i };
            self.scan.push(Corner {
                vertex: self.rim[index].to,
                arrival: Arrival::Rim(index as u32),
            });
            while self.ends_in_ear(draft) {
                let face = faces.pop().expect("bug: more triangles than were cleared");
                suspects.push(self.cut_ear(draft, face));
            }
        }
        match self.scan[..] {
            [
                _,
                Corner {
                    arrival: Arrival::Cut(base),
                    ..
                },
            ] => base,
            _ => unreachable!("bug: a side of a corridor is not visible from the segment"),
        }
    }

    /// Tells whether the last three corners turn left.
    fn ends_in_ear(&self, draft: &Draft) -> bool {
        let [.., u, v, w] = &self.scan[..] else {
            return false;
        };
        let [u, v, w] = [u, v, w].map(|corner| draft.point(corner.vertex));
        orient2d(u, v, w) == Orientation::Left
    }

    /// Cuts off the triangle of the last three corners u, v, w, and returns its half-edge wu.
    fn cut_ear(&mut self, draft: &mut Draft, face: TriangleId) -> HalfEdgeId {
        let [w, v] = [0, 1].map(|_| self.scan.pop().expect("bug: an ear has three corners"));
        let u = self.scan.last().expect("bug: an ear has three corners");
        draft.set_triangle(face, [u.vertex, v.vertex, w.vertex]);
        let [vw, wu, uv] = face.half_edges();
        self.attach(draft, uv, v.arrival);
        self.attach(draft, vw, w.arrival);
        self.scan.push(Corner {
            vertex: w.vertex,
            arrival: Arrival::Cut(wu),
        });
        wu
    }

    /// Bonds half-edge `h` of a new triangle to what lies beyond, or leaves it for that to be bonded to.
    fn attach(&mut self, draft: &mut Draft, h: HalfEdgeId, edge: Arrival) {
        match edge {
            Arrival::Start => unreachable!("bug: nothing arrives at the start"),
            Arrival::Cut(other) => draft.mesh.bond(h, other),
            Arrival::Rim(i) => {
                let RimEdge { beyond, mark, .. } = self.rim[i as usize];
                draft.marks.set(h, mark);
                match beyond {
                    Beyond::Stays(other) => draft.mesh.bond(h, other),
                    Beyond::Rim(other) => self.rim[other as usize].beyond = Beyond::Stays(h),
                }
            }
        }
    }
}
