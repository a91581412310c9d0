//! The triangulation while segments go into it: mesh and points in the numbering of the curve, what
//! is constrained, and one half-edge for each vertex, so that nothing ever has to be searched for.

use super::witness::{Witness, tell_flip, tell_suspect};
use crate::predicates::{Orientation, in_circle_perturbed, orient2d};
use crate::{HalfEdgeId, Mesh, Point, TriangleId, VertexId};

/// Marks a vertex without half-edges: it was merged into another, or is the only one.
pub(super) const NOWHERE: HalfEdgeId = HalfEdgeId::new(u32::MAX as usize);

/// A constrained Delaunay triangulation in the making.
#[derive(Clone)]
pub(crate) struct Draft {
    pub points: Vec<Point>,
    pub mesh: Mesh,
    pub marks: Marks,
    /// A half-edge that starts at each vertex.
    pub(super) outgoing: Vec<HalfEdgeId>,
}

/// What lies ahead when one looks from a vertex towards a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ahead {
    /// The edge of this half-edge, which starts at the vertex and runs exactly that way.
    Along(HalfEdgeId),
    /// The open edge of this half-edge, opposite the vertex: it starts to the right of the line of
    /// sight and ends to its left.
    Across(HalfEdgeId),
    /// Nothing: the vertex is on the hull, and the point lies on the other side of it.
    Outside,
}

impl Draft {
    /// Takes over a Delaunay triangulation, in which nothing is constrained yet.
    pub fn new(points: Vec<Point>, mesh: Mesh) -> Self {
        let mut outgoing = vec![NOWHERE; points.len()];
        for (t, &[a, b, c]) in mesh.faces().iter().enumerate() {
            let [bc, ca, ab] = TriangleId::new(t).half_edges();
            for (v, h) in [(a, ab), (b, bc), (c, ca)] {
                if !v.is_infinite() {
                    outgoing[v.index()] = h;
                }
            }
        }
        let marks = Marks::new(mesh.num_faces());
        Self {
            points,
            mesh,
            marks,
            outgoing,
        }
    }

    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    /// Visits the half-edges that start at `v`, counter-clockwise.
    pub fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> + '_ {
        let first = Some(self.outgoing[v.index()]).filter(|&h| h != NOWHERE);
        first.into_iter().flat_map(|h| self.mesh.star(h))
    }

    /// Finds a half-edge between two vertices, or returns them, the one with fewer edges first.
    ///
    /// *Cost*: the lesser of the two degrees, so that spokes are cheap whichever end is the hub.
    #[inline]
    pub fn find_edge(&self, a: VertexId, b: VertexId) -> Result<HalfEdgeId, [VertexId; 2]> {
        let [first, other_first] = [a, b].map(|v| self.outgoing[v.index()]);
        let (mut h, mut g) = (first, other_first);
        loop {
            let [beside, other_beside] = [h, g].map(HalfEdgeId::prev);
            if self.mesh.apex(beside) == b {
                return Ok(h);
            }
            if self.mesh.apex(other_beside) == a {
                return Ok(g);
            }
            [h, g] = [beside, other_beside].map(|h| self.mesh.twin(h));
            if h == first {
                return Err([a, b]);
            }
            if g == other_first {
                return Err([b, a]);
            }
        }
    }

    /// Looks from vertex `a` towards `goal`, which must be another point.
    pub fn ahead(&self, a: VertexId, goal: Point) -> Ahead {
        let from = self.point(a);
        let side = |v: VertexId| {
            let is_finite = !v.is_infinite();
            is_finite.then(|| orient2d(from, goal, self.point(v)))
        };
        let towards = from.lex_cmp(&goal);
        // The side of the vertex that comes next, where it is known already.
        let mut known = None;
        for h in self.star(a) {
            let w = self.mesh.dest(h);
            match known.take().or_else(|| side(w)) {
                Some(Orientation::Collinear) if from.lex_cmp(&self.point(w)) == towards => {
                    return Ahead::Along(h);
                }
                Some(Orientation::Right) => {
                    known = side(self.mesh.apex(h));
                    if known == Some(Orientation::Left) {
                        return Ahead::Across(h.next());
                    }
                }
                _ => {}
            }
        }
        Ahead::Outside
    }

    /// Builds the triangle `corners` in the face of `t`, whose twins are the caller's to bond.
    #[inline]
    pub fn set_triangle(&mut self, t: TriangleId, corners: [VertexId; 3]) {
        self.mesh.replace_face(t, corners);
        let [a, b, c] = corners;
        let [bc, ca, ab] = t.half_edges();
        for (v, h) in [(a, ab), (b, bc), (c, ca)] {
            self.outgoing[v.index()] = h;
        }
        self.marks.clear_edges(t);
    }

    /// Flips edges between faces of the corridor until all that `suspects` lead to are locally Delaunay
    /// or constrained; false if that takes more than `budget` flips.
    #[must_use]
    pub fn legalise(
        &mut self,
        suspects: &mut Vec<HalfEdgeId>,
        mut budget: usize,
        witness: impl Witness,
    ) -> bool {
        while let Some(h) = suspects.pop() {
            let beyond = self.mesh.twin(h).triangle();
            if !self.marks.is_in_corridor(beyond) {
                continue;
            }
            tell_suspect(witness, self, h);
            if !self.must_flip(h) {
                continue;
            }
            if budget == 0 {
                return false;
            }
            budget -= 1;
            tell_flip(witness, self, h);
            self.flip_suspect(h, suspects);
        }
        true
    }

    /// Flips edges, wherever they are, until all that `suspects` lead to are locally Delaunay or
    /// constrained; false if that takes more than `budget` flips.
    #[must_use]
    pub fn settle(&mut self, suspects: &mut Vec<HalfEdgeId>, mut budget: usize) -> bool {
        while let Some(h) = suspects.pop() {
            let faces = [h, self.mesh.twin(h)].map(HalfEdgeId::triangle);
            if faces.iter().any(|&t| self.mesh.is_ghost(t)) || !self.must_flip(h) {
                continue;
            }
            if budget == 0 {
                return false;
            }
            budget -= 1;
            self.flip_suspect(h, suspects);
        }
        true
    }

    /// Tells whether the edge of `h`, between two triangles, is neither constrained nor locally Delaunay.
    fn must_flip(&self, h: HalfEdgeId) -> bool {
        let g = self.mesh.twin(h);
        if self.marks.is_constrained(h) {
            return false;
        }
        let corners = [
            self.mesh.origin(h),
            self.mesh.dest(h),
            self.mesh.apex(h),
            self.mesh.apex(g),
        ];
        let [a, b, c, d] = corners.map(|v| self.point(v));
        in_circle_perturbed(a, b, c, d)
    }

    /// Flips the edge of `h`, whose quadrilateral's sides become suspect.
    fn flip_suspect(&mut self, h: HalfEdgeId, suspects: &mut Vec<HalfEdgeId>) {
        self.flip(h);
        let g = self.mesh.twin(h.next()).prev();
        suspects.extend([h, h.prev(), g, g.prev()]);
    }

    /// Flips the edge of `h`, and moves the marks of the edges whose half-edges change.
    pub fn flip(&mut self, h: HalfEdgeId) {
        let g = self.mesh.twin(h);
        let [bc, ad] = [h.next(), g.next()].map(|edge| self.marks.get(edge));
        self.mesh.flip(h);
        self.marks.set(h, ad);
        self.marks.set(g, bc);
        self.marks.set(h.next(), Mark::FREE);
        self.marks.set(g.next(), Mark::FREE);
        self.note(h);
        self.note(g);
    }

    /// Lets `h` be the half-edge by which its origin is found.
    #[inline]
    pub(super) fn note(&mut self, h: HalfEdgeId) {
        let origin = self.mesh.origin(h);
        if !origin.is_infinite() {
            self.outgoing[origin.index()] = h;
        }
    }

    /// Constrains the edge of `h`, along which run segments, an odd number of them or not.
    #[inline]
    pub fn constrain(&mut self, h: HalfEdgeId, is_odd: bool) {
        self.marks.add_segments(h, is_odd);
        self.marks.add_segments(self.mesh.twin(h), is_odd);
    }

    /// Lets no segment run along the edge of `h` any more.
    pub fn release(&mut self, h: HalfEdgeId) {
        self.marks.set(h, Mark::FREE);
        self.marks.set(self.mesh.twin(h), Mark::FREE);
    }

    /// Tells on which side of the edge of `h` lies `p`; its face lies to the left.
    pub fn side_of(&self, h: HalfEdgeId, p: Point) -> Orientation {
        let [a, b] = [self.mesh.origin(h), self.mesh.dest(h)].map(|v| self.point(v));
        orient2d(a, b, p)
    }
}

/// What is known of one side of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mark(u8);

impl Mark {
    pub const FREE: Self = Self(0);
}

/// The marks of all half-edges, a byte a face: bit k says that half-edge k is constrained, bit 3 + k
/// that an odd number of segments runs along it. Bit 6 is set while the face is in a corridor.
#[derive(Clone, Debug)]
pub(crate) struct Marks(Vec<u8>);

/// The bit of faces in the corridor.
const CORRIDOR: u8 = 1 << 6;

impl Marks {
    fn new(faces: usize) -> Self {
        Self(vec![0; faces])
    }

    #[inline]
    pub fn is_constrained(&self, h: HalfEdgeId) -> bool {
        self.get(h).0 & 1 != 0
    }

    /// Tells whether an odd number of segments runs along the edge.
    #[inline]
    pub fn is_odd(&self, h: HalfEdgeId) -> bool {
        self.get(h).0 & 8 != 0
    }

    #[inline]
    pub fn get(&self, h: HalfEdgeId) -> Mark {
        Mark(self.0[h.triangle().index()] >> h.slot() & 9)
    }

    #[inline]
    pub fn set(&mut self, h: HalfEdgeId, mark: Mark) {
        let byte = &mut self.0[h.triangle().index()];
        *byte = *byte & !(9 << h.slot()) | mark.0 << h.slot();
    }

    #[inline]
    fn add_segments(&mut self, h: HalfEdgeId, is_odd: bool) {
        let byte = &mut self.0[h.triangle().index()];
        *byte = (*byte | 1 << h.slot()) ^ u8::from(is_odd) << (3 + h.slot());
    }

    /// Forgets what is known of the edges of a face.
    #[inline]
    fn clear_edges(&mut self, t: TriangleId) {
        self.0[t.index()] &= CORRIDOR;
    }

    /// Tells whether a face belongs to the corridor that is being rebuilt.
    #[inline]
    pub fn is_in_corridor(&self, t: TriangleId) -> bool {
        self.0[t.index()] & CORRIDOR != 0
    }

    #[inline]
    pub fn enter_corridor(&mut self, t: TriangleId) {
        self.0[t.index()] |= CORRIDOR;
    }

    #[inline]
    pub fn leave_corridor(&mut self, t: TriangleId) {
        self.0[t.index()] &= !CORRIDOR;
    }

    /// Makes room for so many faces; new ones have no marks.
    pub fn set_number(&mut self, faces: usize) {
        self.0.resize(faces, 0);
    }

    /// Drops the marks of a face, and moves those of the last face into their place.
    pub fn swap_remove(&mut self, t: TriangleId) {
        self.0.swap_remove(t.index());
    }

    /// Hands out the bytes of all faces, of which the lower three bits say what is constrained.
    pub fn into_bytes(self) -> Vec<u8> {
        self.0
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::names::Names;
    use super::*;
    use crate::delaunay::Curve;
    use crate::parallel::Workers;

    /// Triangulates points; the function returned finds the draft's vertex of a point.
    pub fn draft(points: &[(f64, f64)]) -> (Draft, impl Fn(usize) -> VertexId + use<>) {
        let points: Vec<Point> = points.iter().map(|&p| p.into()).collect();
        let parts = Curve::build(&points, Workers::ONE, &())
            .unwrap()
            .into_parts();
        let positions = Names::of(&parts).positions;
        (Draft::new(parts.points, parts.mesh), move |i| positions[i])
    }

    /// A hexagon about the origin, which is vertex 6.
    const WHEEL: [(f64, f64); 7] = [
        (2.0, 0.0),
        (1.0, 2.0),
        (-1.0, 2.0),
        (-2.0, 0.0),
        (-1.0, -2.0),
        (1.0, -2.0),
        (0.0, 0.0),
    ];

    #[test]
    fn every_edge_is_found_from_both_ends() {
        let (draft, v) = draft(&WHEEL);
        for i in 0..6 {
            let [hub, rim, next] = [v(6), v(i), v((i + 1) % 6)];
            for [a, b] in [[hub, rim], [rim, hub], [rim, next], [next, rim]] {
                let h = draft.find_edge(a, b).expect("an edge of the wheel");
                let ends = [draft.mesh.origin(h), draft.mesh.dest(h)];
                assert!(ends == [a, b] || ends == [b, a]);
            }
            assert!(draft.find_edge(rim, v((i + 3) % 6)).is_err());
        }
    }

    #[test]
    fn looking_ahead_sees_edges_gaps_and_the_outside() {
        let (draft, v) = draft(&WHEEL);
        let ends = |h| [draft.mesh.origin(h), draft.mesh.dest(h)];
        for i in 0..6 {
            let (x, y) = WHEEL[i];
            // Along a spoke, before, at and behind its end.
            for scale in [0.5, 1.0, 3.0] {
                let seen = draft.ahead(v(6), Point::new(scale * x, scale * y));
                assert!(matches!(seen, Ahead::Along(h) if ends(h) == [v(6), v(i)]));
            }
            let (z, w) = WHEEL[(i + 1) % 6];
            let seen = draft.ahead(v(6), Point::new(x + z, y + w));
            assert!(matches!(seen, Ahead::Across(h) if ends(h) == [v(i), v((i + 1) % 6)]));
            assert_eq!(
                draft.ahead(v(i), Point::new(2.0 * x, 2.0 * y)),
                Ahead::Outside
            );
        }
    }

    #[test]
    fn marks_go_with_their_edges_through_flips() {
        let corners = [(0.0, 0.0), (3.0, -1.0), (4.0, 2.0), (1.0, 3.0)];
        let (mut draft, v) = draft(&corners);
        let sides = [[0, 1], [1, 2], [2, 3], [3, 0]].map(|ends| ends.map(&v));
        let find = |draft: &Draft, [a, b]: [VertexId; 2]| draft.find_edge(a, b).unwrap();
        draft.constrain(find(&draft, sides[0]), true);
        draft.constrain(find(&draft, sides[2]), true);
        draft.constrain(find(&draft, sides[2]), true);
        let diagonal = [[0, 2], [1, 3]].map(|ends| ends.map(&v));
        let mut h = diagonal
            .into_iter()
            .find_map(|[a, b]| draft.find_edge(a, b).ok())
            .unwrap();
        for _ in 0..4 {
            draft.flip(h);
            h = h.next();
            draft.mesh.validate().expect("flipped");
            for (i, side) in sides.into_iter().enumerate() {
                let h = find(&draft, side);
                for h in [h, draft.mesh.twin(h)] {
                    assert_eq!(draft.marks.is_constrained(h), i % 2 == 0);
                    assert_eq!(draft.marks.is_odd(h), i == 0);
                }
            }
        }
    }
}
