//! One segment: the triangles that it passes through are cleared, and the two sides of this corridor
//! triangulated anew.
//!
//! ```text
//!            l1 ----- l2 --- l3                    l1 ----- l2 --- l3
//!           /  \     /  \   /  \                  /    .----'  ..-'  \
//!          a ==============> end        →        a ================== end
//!           \    \ /     \ /   /                  \ `----.._     _.-' /
//!            `---- r1 --- r2 -'                    `---- r1 --- r2 --'
//! ```
//!
//! Each side is weakly visible from the segment, so a scan in the manner of Graham, which cuts ears as
//! it meets them, triangulates it in linear time (Toussaint and Avis, *On a convex hull algorithm for
//! polygons and its application to triangulation problems*, 1982). Flips then make it constrained
//! Delaunay (Lee and Lin, *Generalized Delaunay triangulation for planar graphs*, 1986); nothing
//! outside the corridor changes. A vertex may stand on a side more than once.
//!
//! Along smooth curves the number of flips is quadratic. When there have been more than a few for each
//! edge, the sides are triangulated [in bulk](super::bulk) instead.
//!
//! *Cost*: in practice linear in the edges crossed; O(k log k) for k of them along curves.

use super::bulk;
use super::draft::{Ahead, Draft};
use super::insert::Edge;
use super::side::Side;
use super::witness::{
    Deed, Outline, Witness, is_watching, tell_clearing, tell_lock, tell_of, tell_rebuilt,
};
use crate::predicates::{Orientation, orient2d};
use crate::{HalfEdgeId, TriangleId, VertexId};

/// A segment cannot be inserted: it crosses one that has been.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Blocked;

/// Flips for each face of a corridor after which a side is triangulated in bulk: where flips get by at
/// all, two or three are enough.
pub(super) const FLIPS_PER_FACE: usize = 32;

/// How deep bulk triangulations of sides may nest; each has fewer vertices than the one around it.
const MAX_DEPTH: u32 = 8;

/// Inserts segments; keeps the lists that it needs from one to the next.
#[derive(Clone)]
pub(crate) struct Inserter<W = ()> {
    witness: W,
    /// The triangles of the corridor.
    faces: Vec<TriangleId>,
    left: Side,
    right: Side,
    suspects: Vec<HalfEdgeId>,
    /// Whether an odd number of segments runs along the edge that is being inserted.
    is_odd: bool,
    /// Edges inserted, vertices passed and faces rebuilt since somebody asked.
    work: usize,
    /// How many bulk triangulations this one is part of.
    depth: u32,
}

impl Default for Inserter {
    fn default() -> Self {
        Self::before(())
    }
}

impl<W: Witness> Inserter<W> {
    /// Makes an inserter that works before a witness.
    pub fn before(witness: W) -> Self {
        Self {
            witness,
            faces: Vec::new(),
            left: Side::default(),
            right: Side::default(),
            suspects: Vec::new(),
            is_odd: false,
            work: 0,
            depth: 0,
        }
    }

    /// Makes an inserter for the side of a corridor of this one.
    pub fn nested(&self) -> Inserter {
        Inserter {
            depth: self.depth + 1,
            ..Inserter::default()
        }
    }

    /// Tells whether at least `amount` of work has been done since it last said so.
    pub fn take_work(&mut self, amount: usize) -> bool {
        let is_due = self.work >= amount;
        if is_due {
            self.work = 0;
        }
        is_due
    }

    /// Inserts an edge, whose ends differ, and adds the vertices that it runs through to `through`. When
    /// it is blocked, part of it may be in.
    ///
    /// Works from both ends, always from the one with fewer edges: turning round a vertex with many is
    /// what costs.
    pub fn insert(
        &mut self,
        draft: &mut Draft,
        edge: Edge,
        through: &mut Vec<VertexId>,
    ) -> Result<(), Blocked> {
        self.work += 1;
        let mut later = Vec::new();
        let [mut first, mut last] = edge.ends;
        self.is_odd = edge.is_odd;
        loop {
            let [from, to] = match draft.find_edge(first, last) {
                Ok(h) => {
                    self.lock(draft, h);
                    break;
                }
                Err(ends) => ends,
            };
            self.work += 1;
            let next = self.advance(draft, from, to)?;
            if next == to {
                break;
            }
            if from == first {
                through.push(next);
                first = next;
            } else {
                later.push(next);
                last = next;
            }
        }
        through.extend(later.into_iter().rev());
        Ok(())
    }

    /// Inserts the first part of the segment from `from` to `to`, up to the vertex that is returned.
    fn advance(
        &mut self,
        draft: &mut Draft,
        from: VertexId,
        to: VertexId,
    ) -> Result<VertexId, Blocked> {
        match draft.ahead(from, draft.point(to)) {
            Ahead::Along(h) => {
                self.lock(draft, h);
                Ok(draft.mesh.dest(h))
            }
            Ahead::Across(h) => self.insert_across(draft, from, to, h),
            Ahead::Outside => unreachable!("bug: a segment leaves the hull"),
        }
    }

    fn lock(&self, draft: &mut Draft, h: HalfEdgeId) {
        tell_lock(self.witness, draft, h);
        draft.constrain(h, self.is_odd);
    }

    /// Inserts the part of the segment `ab` up to the first vertex on it, which is returned; `first`
    /// is the edge through which it leaves the triangles of `a`.
    fn insert_across(
        &mut self,
        draft: &mut Draft,
        a: VertexId,
        b: VertexId,
        first: HalfEdgeId,
    ) -> Result<VertexId, Blocked> {
        let end = self.collect(draft, [a, b], first)?;
        if is_watching(self.witness) {
            tell_clearing(self.witness, draft, &self.faces);
            self.witness.tell(Deed::EdgeCreated([a, end]));
        }
        if !self.fill(draft, a, end) {
            self.fill_in_bulk(draft, a, end);
        }
        self.work += self.faces.len();
        for &face in &self.faces {
            draft.marks.leave_corridor(face);
        }
        Ok(end)
    }

    /// Fills both sides by scanning and flipping; false if that takes too many flips.
    fn fill(&mut self, draft: &mut Draft, a: VertexId, end: VertexId) -> bool {
        self.suspects.clear();
        let mut faces = self.faces.iter().copied();
        // Counter-clockwise the right side runs from a to the end, the left side back to a.
        let (suspects, witness) = (&mut self.suspects, self.witness);
        let right = self.right.fill(a, draft, &mut faces, suspects, witness);
        let left = self.left.fill(end, draft, &mut faces, suspects, witness);
        draft.mesh.bond(left, right);
        self.lock(draft, left);
        let budget = self.budget();
        draft.legalise(&mut self.suspects, budget, witness)
    }

    /// Returns how many flips are allowed.
    fn budget(&self) -> usize {
        match self.faces.len() {
            _ if self.depth == MAX_DEPTH => usize::MAX,
            // Both ways lead to the same triangles. The tests beside take the rare one often.
            n if cfg!(test) && n % 2 == 0 => 0,
            n => FLIPS_PER_FACE * n,
        }
    }

    /// Fills both sides anew, after flips have not got by.
    #[cold]
    fn fill_in_bulk(&mut self, draft: &mut Draft, a: VertexId, end: VertexId) {
        let before = match is_watching(self.witness) {
            true => Outline::of(draft, &self.faces),
            false => Outline::default(),
        };
        let mut faces = self.faces.iter().copied();
        let right = bulk::fill(&self.right, a, draft, &mut faces, self.nested());
        let left = bulk::fill(&self.left, end, draft, &mut faces, self.nested());
        draft.mesh.bond(left, right);
        draft.constrain(left, self.is_odd);
        if is_watching(self.witness) {
            tell_rebuilt(self.witness, draft, &self.faces, &before);
        }
    }

    /// Lists the triangles of the corridor and the edges along its sides; of the draft it marks the
    /// faces only.
    ///
    /// ```text
    ///            w                  crossing: r → l in the triangle behind, and its twin ahead, whose
    ///          /   \                apex w continues one of the sides, or is the end
    ///        l ----- r
    ///         \ ab↑ /
    /// ```
    fn collect(
        &mut self,
        draft: &mut Draft,
        [a, b]: [VertexId; 2],
        first: HalfEdgeId,
    ) -> Result<VertexId, Blocked> {
        self.faces.clear();
        self.left.clear();
        self.right.clear();
        self.enter(draft, first.triangle());
        self.left.push(draft, first.next());
        self.right.push(draft, first.prev());
        let [from, to] = [a, b].map(|v| draft.point(v));
        let mut crossing = first;
        let end = loop {
            tell_of(self.witness, draft, crossing, Deed::Cross);
            if draft.marks.is_constrained(crossing) {
                return Err(Blocked);
            }
            let ahead = draft.mesh.twin(crossing);
            self.enter(draft, ahead.triangle());
            let [rw, wl] = [ahead.next(), ahead.prev()];
            let w = draft.mesh.apex(ahead);
            let side = if w == b {
                Orientation::Collinear
            } else {
                self.witness.tell(Deed::Turn([a, b, w]));
                orient2d(from, to, draft.point(w))
            };
            match side {
                Orientation::Left => {
                    self.left.push(draft, wl);
                    crossing = rw;
                }
                Orientation::Right => {
                    self.right.push(draft, rw);
                    crossing = wl;
                }
                Orientation::Collinear => {
                    self.left.push(draft, wl);
                    self.right.push(draft, rw);
                    break w;
                }
            }
        };
        self.left.reverse();
        Ok(end)
    }

    fn enter(&mut self, draft: &mut Draft, face: TriangleId) {
        draft.marks.enter_corridor(face);
        self.faces.push(face);
    }
}

#[cfg(test)]
mod tests {
    use super::super::draft::tests::draft;
    use super::*;
    use crate::predicates::in_circle_perturbed;

    /// Requires a sphere of counter-clockwise triangles, locally Delaunay but for what is constrained.
    fn require_constrained_delaunay(draft: &Draft) {
        draft.mesh.validate().expect("a sphere");
        for t in draft.mesh.triangles() {
            let [a, b, c] = draft.mesh.corners(t).map(|v| draft.point(v));
            assert_eq!(orient2d(a, b, c), Orientation::Left);
            assert!(!draft.marks.is_in_corridor(t));
        }
        for h in draft.mesh.half_edges() {
            let g = draft.mesh.twin(h);
            assert_eq!(draft.marks.get(h), draft.marks.get(g));
            let corners = [
                draft.mesh.origin(h),
                draft.mesh.dest(h),
                draft.mesh.apex(h),
                draft.mesh.apex(g),
            ];
            if !draft.marks.is_constrained(h) && !corners.iter().any(|v| v.is_infinite()) {
                let [a, b, c, d] = corners.map(|v| draft.point(v));
                assert!(!in_circle_perturbed(a, b, c, d));
            }
        }
    }

    fn insert(draft: &mut Draft, ends: [VertexId; 2]) -> Result<Vec<VertexId>, Blocked> {
        let mut through = Vec::new();
        let is_odd = true;
        Inserter::default().insert(draft, Edge { ends, is_odd }, &mut through)?;
        Ok(through)
    }

    /// A lattice of 7 by 7 points; vertex 7y + x is (x, y).
    fn lattice() -> (Draft, impl Fn(usize) -> VertexId) {
        let points: Vec<_> = (0..49)
            .map(|i| (f64::from(i % 7), f64::from(i / 7)))
            .collect();
        draft(&points)
    }

    #[test]
    fn a_segment_runs_through_the_vertices_on_it() {
        let (mut draft, v) = lattice();
        assert_eq!(
            insert(&mut draft, [v(0), v(48)]),
            Ok([8, 16, 24, 32, 40].map(&v).to_vec())
        );
        assert_eq!(
            insert(&mut draft, [v(34), v(28)]),
            Ok([33, 32, 31, 30, 29].map(&v).to_vec())
        );
        assert_eq!(insert(&mut draft, [v(1), v(17)]), Ok(vec![v(9)]));
        assert_eq!(insert(&mut draft, [v(2), v(27)]), Ok(Vec::new()));
        require_constrained_delaunay(&draft);
    }

    #[test]
    fn a_crossing_blocks() {
        let (mut draft, v) = lattice();
        assert_eq!(insert(&mut draft, [v(0), v(13)]), Ok(Vec::new()));
        assert_eq!(insert(&mut draft, [v(1), v(7)]), Err(Blocked));
    }

    /// All segments from one corner that miss all vertices, in any order, make the same triangles.
    #[test]
    fn the_order_of_segments_does_not_matter() {
        let targets = [8 + 7 * 5, 17, 25, 26, 33, 34, 41, 47, 45, 43];
        let triangles = |order: &mut dyn Iterator<Item = usize>| {
            let (mut draft, v) = lattice();
            for i in order {
                let _ = insert(&mut draft, [v(0), v(targets[i])]).expect("no crossing");
            }
            require_constrained_delaunay(&draft);
            let mut faces: Vec<_> = draft.mesh.faces().to_vec();
            for face in &mut faces {
                let least = (0..3).min_by_key(|&k| face[k]).unwrap();
                face.rotate_left(least);
            }
            faces.sort_unstable();
            faces
        };
        let forwards = triangles(&mut (0..targets.len()));
        assert_eq!(triangles(&mut (0..targets.len()).rev()), forwards);
        assert_eq!(
            triangles(&mut (0..targets.len()).map(|i| i * 7 % 10)),
            forwards
        );
    }

    /// Hanging from p by the edge pq is a triangle qxy, and the corridor goes all around it: between the
    /// two sides of pq the rim passes three edges that it passes only once.
    #[test]
    fn an_edge_may_hang_into_the_corridor_with_triangles_at_its_end() {
        let (mut draft, v) = draft(&[
            (-20.0, 0.0),
            (20.0, 0.0),
            (0.0, 2.0),
            (0.0, 1.0),
            (-0.01, 0.9),
            (0.01, 0.9),
            (-3.0, -1.0),
            (3.0, -1.0),
        ]);
        let h = draft.find_edge(v(2), v(3)).expect("pq is an edge");
        for side in [h, draft.mesh.twin(h)] {
            let below = draft.mesh.apex(side);
            assert!(
                [v(6), v(7)].contains(&below),
                "the segment passes beside pq"
            );
        }
        for ends in [[3, 4], [4, 5], [5, 3]] {
            assert!(draft.find_edge(v(ends[0]), v(ends[1])).is_ok());
        }
        assert_eq!(insert(&mut draft, [v(0), v(1)]), Ok(Vec::new()));
        require_constrained_delaunay(&draft);
    }

    /// Along a smooth curve flips do not get by, so the sides are triangulated in bulk.
    #[test]
    fn a_chord_of_a_curve() {
        let arc = |i: i32| {
            let x = f64::from(i) / 300.0;
            (x, 0.01 + 0.3 * x * (1.0 - x))
        };
        let mut points: Vec<_> = (1..300).map(arc).collect();
        points.extend((1..300).map(arc).map(|(x, y)| (x + 1e-6, -y)));
        points.extend([(0.0, 0.0), (1.1, 0.0)]);
        let (mut draft, v) = draft(&points);
        let ends = [v(points.len() - 2), v(points.len() - 1)];
        assert_eq!(insert(&mut draft, ends), Ok(Vec::new()));
        require_constrained_delaunay(&draft);
    }
}
