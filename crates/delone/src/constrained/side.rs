//! One side of a corridor: the edges that bound it, and how it is filled by cutting ears.

use super::draft::{Draft, Mark};
use super::witness::{Deed, Witness, is_watching};
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, TriangleId, VertexId};

/// The edges along one side of a corridor: first in the order in which the segment passes them, in the
/// end counter-clockwise about the side.
#[derive(Clone, Default)]
pub(super) struct Side {
    pub rim: Vec<RimEdge>,
    /// The edges whose other side may still turn up on this rim, as a stack.
    open: Vec<u32>,
    /// For each edge of the rim what was built first where both of its sides are on the rim.
    built: Vec<Option<HalfEdgeId>>,
    scan: Vec<Corner>,
}

/// An edge between the corridor and what stays.
#[derive(Clone, Copy)]
pub(super) struct RimEdge {
    /// Where it ends.
    pub to: VertexId,
    pub beyond: Beyond,
    pub mark: Mark,
    /// Its half-edge in the corridor as it was.
    within: HalfEdgeId,
}

/// What lies beyond an edge of the rim.
#[derive(Clone, Copy)]
pub(super) enum Beyond {
    /// This half-edge, which stays.
    Stays(HalfEdgeId),
    /// The corridor itself: the other side of the edge stands at this index of the same rim.
    Rim(u32),
}

/// A corner of the path that is left while ears are cut.
#[derive(Clone, Copy)]
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
    /// An edge that only leads into the corridor is passed on both sides. Such pairs nest, but what
    /// stands between the two need not be pairs: the edge may carry triangles at its end.
    #[inline]
    pub fn push(&mut self, draft: &Draft, within: HalfEdgeId) {
        let index = self.rim.len() as u32;
        let twin = draft.mesh.twin(within);
        let beyond = if draft.marks.is_in_corridor(twin.triangle()) {
            let other = self.close(twin);
            self.rim[other as usize].beyond = Beyond::Rim(index);
            Beyond::Rim(other)
        } else {
            self.open.push(index);
            Beyond::Stays(twin)
        };
        self.rim.push(RimEdge {
            to: draft.mesh.dest(within),
            beyond,
            mark: draft.marks.get(within),
            within,
        });
    }

    /// Finds the edge that had half-edge `within`.
    #[cold]
    fn close(&mut self, within: HalfEdgeId) -> u32 {
        loop {
            let other = self.open.pop().expect("bug: the other side is on this rim");
            if self.rim[other as usize].within == within {
                return other;
            }
        }
    }

    /// Turns the rim of a left side round, so that it runs counter-clockwise about its side.
    pub fn reverse(&mut self) {
        self.rim.reverse();
        let last = self.rim.len() as u32 - 1;
        for edge in &mut self.rim {
            if let Beyond::Rim(other) = &mut edge.beyond {
                *other = last - *other;
            }
        }
    }

    /// Fills the side with triangles, in the next of `faces`, and returns the half-edge of the segment
    /// in them, whose twin is still to be bonded. The rim begins at vertex `start`.
    ///
    /// The new edges are added to `suspects`: they may not be Delaunay. That of the segment a witness
    /// knows already.
    pub fn fill(
        &mut self,
        start: VertexId,
        draft: &mut Draft,
        faces: &mut impl Iterator<Item = TriangleId>,
        suspects: &mut Vec<HalfEdgeId>,
        witness: impl Witness,
    ) -> HalfEdgeId {
        self.built.clear();
        self.built.resize(self.rim.len(), None);
        self.scan.clear();
        self.scan.push(Corner {
            vertex: start,
            arrival: Arrival::Start,
        });
        for index in 0..self.rim.len() {
            self.scan.push(Corner {
                vertex: self.rim[index].to,
                arrival: Arrival::Rim(index as u32),
            });
            while self.ends_in_ear(draft, witness) {
                let face = faces.next().expect("bug: more triangles than were cleared");
                suspects.push(self.cut_ear(draft, face));
                if is_watching(witness) {
                    self.tell_ear(start, draft.mesh.corners(face), witness);
                }
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
    fn ends_in_ear(&self, draft: &Draft, witness: impl Witness) -> bool {
        let [.., u, v, w] = &self.scan[..] else {
            return false;
        };
        let corners = [u, v, w].map(|corner| corner.vertex);
        witness.tell(Deed::Turn(corners));
        let [u, v, w] = corners.map(|v| draft.point(v));
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

    /// Tells of the triangle that has been cut off a side whose rim begins at `start`.
    fn tell_ear(&self, start: VertexId, [u, v, w]: [VertexId; 3], witness: impl Witness) {
        witness.tell(Deed::Ear);
        let end = self.rim.last().expect("bug: a side without edges").to;
        if [u, w] != [start, end] {
            witness.tell(Deed::EdgeCreated([w, u]));
        }
        witness.tell(Deed::TriangleCreated([u, v, w]));
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
                    Beyond::Rim(other) => match self.built[other as usize] {
                        Some(other) => draft.mesh.bond(h, other),
                        None => self.built[i as usize] = Some(h),
                    },
                }
            }
        }
    }
}
