//! A live triangulation from one that was built in bulk.

use super::constraints::Constraints;
use super::slots::Slots;
use super::{LiveTriangulation, is_straight};
use crate::constrained::Draft;
use crate::{ConstrainedDelaunay, ConstrainedTriangulation, Pslg, Triangulation, VertexId};
use std::ops::Range;

/// Flips for each face of the whole triangulation after which one from scratch costs less.
const FLIPS_PER_FACE: usize = 8;

impl LiveTriangulation {
    /// Takes over the points of a triangulation, which keep their numbers; those that were merged into
    /// others are not there, and their numbers are free.
    ///
    /// What was constrained in it, or carved away, is forgotten: the result is the Delaunay
    /// triangulation of the vertices. [`from_constrained`](Self::from_constrained) keeps constraints.
    ///
    /// *Cost*: O(n log n), about 0.2 µs for each vertex of a million.
    pub fn from_triangulation(t: &Triangulation) -> Self {
        let mut live = Self::of(draft_of(t), slots_of(t), Constraints::default());
        let mesh = live.mesh();
        live.room.suspects = mesh.half_edges().filter(|&h| h < mesh.twin(h)).collect();
        // Nothing happens if nothing was constrained.
        live.settle();
        live
    }

    /// Takes over points and segments of a domain, or of a refined mesh. Vertices keep their numbers.
    ///
    /// Also returns the [numbers](super::ConstraintId::new) of the constraints of each segment: one with
    /// the segment's ends, if all vertices along it lie exactly upon it; else, as where segments cross or
    /// were refined and coordinates had to be rounded, one for each edge along it; none if it has no
    /// length. What was carved away comes back.
    ///
    /// *Cost*: O(n log n) for n vertices and edges of segments.
    pub fn from_constrained(t: &ConstrainedTriangulation) -> (Self, Vec<Range<usize>>) {
        let triangulation = t.triangulation();
        let mut chains = Vec::new();
        let mut of_segments = Vec::with_capacity(t.segments().len());
        for segment in 0..t.segments().len() {
            let first = chains.len();
            let chain = t.chain(segment);
            if chain.len() > 1 && is_straight(chain, |v| triangulation.point(v)) {
                chains.push(chain.to_vec());
            } else {
                chains.extend(chain.windows(2).map(<[VertexId]>::to_vec));
            }
            of_segments.push(first..chains.len());
        }
        let mut draft = draft_of(triangulation);
        copy_marks(t, &mut draft);
        let live = Self::of(draft, slots_of(triangulation), Constraints::new(&chains));
        (live, of_segments)
    }
}

impl LiveTriangulation {
    /// Flips what is suspect. Where long smooth curves come to face each other, that may need a number of
    /// flips that is quadratic; if there are too many, begins from scratch.
    pub(super) fn settle(&mut self) {
        let suspects = &mut self.room.suspects;
        let budget = match self.draft.mesh.num_faces() {
            // Both ways lead to the same triangles. The tests beside take the rare one often.
            n if cfg!(test) && n.is_multiple_of(4) => 0,
            n => FLIPS_PER_FACE * n,
        };
        if !self.draft.settle(suspects, budget) {
            self.rebuild();
        }
    }

    /// Triangulates vertices and constraints from scratch.
    #[cold]
    fn rebuild(&mut self) {
        let vertices: Vec<VertexId> = self.vertices().collect();
        let names = self.names_without_gaps(&vertices);
        let mut pslg = Pslg::from_points(vertices.iter().map(|&v| self.draft.point(v)));
        for ends in self.constraints().filter_map(|id| self.constraint(id)) {
            pslg.segments.push(ends.map(|v| names[v.index()]));
        }
        let t = ConstrainedDelaunay::new().threads(1).triangulate(pslg);
        let t = t.expect("bug: constraints do not cross");
        let mut mesh = t.triangulation().mesh().clone();
        mesh.rename_vertices(&vertices);
        self.draft = Draft::new(std::mem::take(&mut self.draft.points), mesh);
        copy_marks(&t, &mut self.draft);
    }

    /// Returns for each vertex its place among `vertices`, which are all there are.
    pub(super) fn names_without_gaps(&self, vertices: &[VertexId]) -> Vec<VertexId> {
        let mut names = vec![VertexId::INFINITE; self.draft.points.len()];
        for (i, v) in vertices.iter().enumerate() {
            names[v.index()] = VertexId::new(i);
        }
        names
    }
}

impl From<&Triangulation> for LiveTriangulation {
    fn from(t: &Triangulation) -> Self {
        Self::from_triangulation(t)
    }
}

fn draft_of(t: &Triangulation) -> Draft {
    Draft::new(t.points().to_vec(), t.mesh().clone())
}

/// Constrains the edges of a draft that are constrained in `t`, which has the same half-edges.
fn copy_marks(t: &ConstrainedTriangulation, draft: &mut Draft) {
    for h in draft.mesh.half_edges() {
        if t.is_constrained(h) && h < draft.mesh.twin(h) {
            draft.constrain(h, false);
        }
    }
}

fn slots_of(t: &Triangulation) -> Slots {
    let mut is_used = vec![true; t.points().len()];
    for duplicate in t.duplicates() {
        is_used[duplicate.dropped.index()] = false;
    }
    Slots::new(is_used)
}

#[cfg(test)]
mod tests {
    //! In unit tests every second triangulation is settled by making it from scratch.

    use super::*;
    use crate::{Point, triangulate};

    #[test]
    fn constraints_leave_no_trace_and_small_moves_are_like_large_ones() {
        for n in 20..60 {
            let at = |i: u32| Point::new(f64::from(i * i % 61), f64::from(i * 7 % 23));
            let t = triangulate((0..n).map(at)).expect("finite points");
            let mut live = LiveTriangulation::from(&t);
            let first = live.vertices().next().expect("a vertex");
            live.remove(first).expect("a vertex");
            let ends: Vec<_> = live.vertices().collect();
            let pairs = ends.iter().zip(ends.iter().rev());
            let added = pairs.filter_map(|(&a, &b)| live.add_constraint(a, b).ok());
            let added: Vec<_> = { added }.collect();
            assert!(!added.is_empty());
            for &v in &ends {
                let p = live.point(v).expect("a vertex");
                let _ = live.move_to(v, (p.x + 0.0625, p.y - 0.125));
            }
            for id in added {
                live.remove_constraint(id).expect("there");
                live.mesh().validate().expect("a sphere");
            }
            let points = live.vertices().filter_map(|v| live.point(v));
            let fresh = triangulate(points).expect("finite points");
            assert_eq!(live.hash(), fresh.hash());
        }
    }
}
