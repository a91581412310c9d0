//! The edits: the only places where corners and twins are rewritten.
//!
//! Each edit keeps the structure a closed sphere and costs constant time, but for
//! [`Mesh::contract`]. None asks where a vertex lies, so each works on ghosts as on triangles: letters
//! in the pictures may stand for the vertex at infinity. The caller answers for geometry, these
//! functions for topology.
//!
//! A picture shows the faces before and after; a half-edge id keeps its meaning unless the text
//! says otherwise. What a growing edit returns is the *link* of the new vertex: the half-edges
//! opposite to it, counter-clockwise, which are the ones to legalise.

use super::{HalfEdgeId, Mesh, TriangleId, VertexId};

/// A face has got another id, or the last one has vanished: then both are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Moved {
    /// Its id before.
    pub from: TriangleId,
    /// Its id from now on.
    pub to: TriangleId,
}

impl Moved {
    /// Returns what face `t` is called from now on.
    #[inline]
    pub fn face(self, t: TriangleId) -> TriangleId {
        if t == self.from { self.to } else { t }
    }

    /// Returns what half-edge `h` is called from now on.
    #[inline]
    pub fn half_edge(self, h: HalfEdgeId) -> HalfEdgeId {
        self.face(h.triangle()).half_edges()[h.slot()]
    }
}

impl Mesh {
    /// Makes the mesh of two vertices, and returns the half-edge from `a` to `b`.
    ///
    /// ```text
    ///            ∞
    ///        t   |           t = (a, b, ∞) lies left of ab, u = (b, a, ∞) right of it;
    ///      a ----+---- b     they are glued along all three edges.
    ///        u   |
    ///            ∞
    /// ```
    ///
    /// *Ids invalidated*: all.
    pub fn seed(&mut self, a: VertexId, b: VertexId) -> HalfEdgeId {
        self.clear();
        let t = self.push_face([a, b, VertexId::INFINITE]).half_edges();
        let u = self.push_face([b, a, VertexId::INFINITE]).half_edges();
        self.bond(t[0], u[1]);
        self.bond(t[1], u[0]);
        self.bond(t[2], u[2]);
        t[2]
    }

    /// Puts vertex `v` into face `t`, which becomes three faces.
    ///
    /// ```text
    ///          c                      c
    ///         / \                    /|\           t = (a, b, v) keeps its half-edge ab;
    ///        /   \                  / | \          bc and ca move to the new faces
    ///       /  t  \       →        /w v u\         u = (b, c, v) and w = (c, a, v).
    ///      /       \              / / t \ \
    ///     a ------- b            a ------- b
    /// ```
    ///
    /// Returns ab, bc, ca.
    pub fn split_face(&mut self, t: TriangleId, v: VertexId) -> [HalfEdgeId; 3] {
        let [a, b, c] = self.corners(t);
        let [bc, ca, ab] = t.half_edges();
        let u = self.push_face([b, c, v]).half_edges();
        let w = self.push_face([c, a, v]).half_edges();
        self.relocate(bc, u[2]);
        self.relocate(ca, w[2]);
        self.set_apex(ab, v);
        self.bond(bc, u[1]);
        self.bond(u[0], w[1]);
        self.bond(w[0], ca);
        [ab, u[2], w[2]]
    }

    /// Puts vertex `v` on the edge of `h`, whose two faces become four.
    ///
    /// ```text
    ///           c                        c
    ///          / \                      /|\
    ///         /   \                    / | \        h and its twin stay at a: they are now av
    ///        /  h→ \                  / h|  \       and va. ca and ad keep their ids; bc moves
    ///       a ----- b        →       a --v-- b      to the new face u = (v, b, c), db to
    ///        \     /                  \  |  /       w = (v, d, b).
    ///         \   /                    \ | /
    ///          \ /                      \|/
    ///           d                        d
    /// ```
    ///
    /// Returns ca, ad, db, bc.
    pub fn split_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 4] {
        let g = self.twin(h);
        let [b, c, d] = [self.dest(h), self.apex(h), self.apex(g)];
        let u = self.push_face([v, b, c]).half_edges();
        let w = self.push_face([v, d, b]).half_edges();
        self.relocate(h.next(), u[0]);
        self.relocate(g.prev(), w[0]);
        self.set_apex(h.prev(), v);
        self.set_apex(g.next(), v);
        self.bond(u[1], h.next());
        self.bond(u[2], w[1]);
        self.bond(w[2], g.prev());
        [h.prev(), g.next(), w[0], u[0]]
    }

    /// Opens the edge of `h` into two parallel ones, with vertex `v` of degree two between them.
    ///
    /// ```text
    ///            h→                      h→
    ///       a ------- b             .---------.
    ///                              /     u     \       h and its twin keep their ids and faces;
    ///                     →       a ---- v ---- b      new between them are u = (b, a, v) and
    ///                              \     w     /       w = (a, b, v).
    ///                               '---------'
    /// ```
    ///
    /// With b at infinity this lengthens a row of collinear vertices that ends in a.
    /// Returns ba in u and ab in w.
    pub fn open_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 2] {
        let (a, b, g) = (self.origin(h), self.dest(h), self.twin(h));
        let u = self.push_face([b, a, v]).half_edges();
        let w = self.push_face([a, b, v]).half_edges();
        self.bond(h, u[2]);
        self.bond(g, w[2]);
        self.bond(u[0], w[1]);
        self.bond(u[1], w[0]);
        [u[2], w[2]]
    }

    /// Replaces the edge of `h` by the other diagonal of its quadrilateral.
    ///
    /// ```text
    ///           c                      c
    ///          / \                    /|\        t, the face of h, changes its corner b to d; the
    ///         / t \                  / | \       face u of the twin g changes its corner a to c.
    ///        /  h→ \                /  |  \      ca and db keep their ids. h is now ad, g is bc;
    ///       a ----- b       →      a t | u b     the new diagonal is dc = h.next() in t and
    ///        \  ←g /                \  |  /      cd = g.next() in u.
    ///         \ u /                  \ | /
    ///          \ /                    \|/
    ///           d                      d
    /// ```
    ///
    /// The edges that c now sees are thus `h` and `g.prev()`. The quadrilateral must have four
    /// different corners.
    pub fn flip(&mut self, h: HalfEdgeId) {
        let g = self.twin(h);
        let [c, d] = [self.apex(h), self.apex(g)];
        debug_assert_ne!(c, d, "bug: flipped an edge between two faces on one vertex");
        self.relocate(g.next(), h);
        self.relocate(h.next(), g);
        self.set_apex(h.prev(), d);
        self.set_apex(g.prev(), c);
        self.bond(h.next(), g.next());
    }

    /// Removes the vertex of degree three from which `h` starts; undoes
    /// [`split_face`](Self::split_face).
    ///
    /// ```text
    ///          c                      c
    ///         /|\                    / \
    ///        / | \                  /   \          t, the face of h = va, becomes (a, b, c) and
    ///       /  v u\        →       /  t  \         keeps its half-edge ab; u and w vanish.
    ///      /w/ t \ \              /       \
    ///     a ------- b            a ------- b
    /// ```
    ///
    /// Returns ab. *Ids invalidated*: those of u and w; the two last faces take their places, so
    /// the half-edge returned may have a new id too.
    pub fn remove_degree_three(&mut self, h: HalfEdgeId) -> HalfEdgeId {
        let (va, ab, bv) = (h, h.next(), h.prev());
        let (bc, ca) = (self.twin(bv).next(), self.twin(va).prev());
        let c = self.dest(bc);
        debug_assert_eq!(c, self.origin(ca), "bug: the vertex has not degree three");
        self.relocate(bc, bv);
        self.relocate(ca, va);
        self.set_apex(ab, c);
        let moved = self.remove_faces([bc.triangle(), ca.triangle()]);
        moved.into_iter().fold(ab, |h, moved| moved.half_edge(h))
    }

    /// Contracts the edge of `h`, from v to a: v goes, and what is left of its star becomes part of
    /// that of a. Undoes [`open_edge`](Self::open_edge), [`split_edge`](Self::split_edge) and
    /// [`split_face`](Self::split_face).
    ///
    /// ```text
    ///           c                       c
    ///          /|\                     / \
    ///         / | \                   /   \       the face of h = va and that of its twin vanish;
    ///        /  |  \                 /     \      vc and ac become one edge, so do dv and da. All
    ///       . --v-h→a       →       . ----- a     other faces of v have a where they had v.
    ///        \  |  /                 \     /
    ///         \ | /                   \   /
    ///          \|/                     \ /
    ///           d                       d
    /// ```
    ///
    /// There must be at least three finite vertices, and no vertex beside a, c and d may be adjacent to
    /// both v and a. With a at infinity and v on the hull, the other faces of v become ghosts.
    ///
    /// Returns which faces have got new ids. *Ids invalidated*: those of the two faces that vanish, and
    /// of the two last ones, which take their places. *Cost*: the degree of v.
    pub fn contract(&mut self, h: HalfEdgeId) -> [Moved; 2] {
        let (g, a) = (self.twin(h), self.dest(h));
        let mut spoke = self.onext(h);
        while spoke != h {
            self.set_apex(spoke.next(), a);
            spoke = self.onext(spoke);
        }
        self.relocate(h.next(), self.twin(h.prev()));
        self.relocate(g.prev(), self.twin(g.next()));
        self.remove_faces([h.triangle(), g.triangle()])
    }

    /// Replaces a disc of `faces` by triangles that join `v` to its `rim`: the half-edges beyond it,
    /// counter-clockwise. Faces that are left over are appended to `free`, and taken from there, or made,
    /// when there are too few.
    ///
    /// ```text
    ///        .--<--.                       .-----.
    ///       / \   / \                     / \   / \      n edges around, k vertices inside:
    ///      '---- x ---'         →        '---- v ---'    n − 2 + 2k faces before, n after
    ///       \ /   \ /                     \ /   \ /
    ///        '-->--'                       '-----'
    /// ```
    ///
    /// Returns a half-edge that starts at `v`. *Ids invalidated*: half-edges of the disc.
    pub(crate) fn fill(
        &mut self,
        faces: &mut Vec<TriangleId>,
        rim: &[HalfEdgeId],
        free: &mut Vec<TriangleId>,
        v: VertexId,
    ) -> HalfEdgeId {
        let n = rim.len();
        while faces.len() < n {
            let t = free.pop().unwrap_or_else(|| self.push_face([v; 3]));
            faces.push(t);
        }
        free.extend(faces.drain(n..));
        let mut before = faces[n - 1].half_edges()[1];
        for (&t, &outer) in faces.iter().zip(rim) {
            let [base, incoming, outgoing] = t.half_edges();
            self.replace_face(t, [v, self.dest(outer), self.origin(outer)]);
            self.bond(base, outer);
            self.bond(outgoing, before);
            before = incoming;
        }
        faces[0].half_edges()[2]
    }

    /// Drops all faces.
    pub(crate) fn clear(&mut self) {
        self.corners.clear();
        self.twins.clear();
    }

    /// Moves the ghosts behind the triangles, each kind in its old order, and returns the number of
    /// triangles.
    ///
    /// *Ids invalidated*: all but those of vertices. *Cost*: linear.
    pub fn sort_ghosts_last(&mut self) -> usize {
        let faces = (0..self.num_faces()).map(TriangleId::new);
        let (ghosts, mut order): (Vec<_>, Vec<_>) = faces.partition(|&t| self.is_ghost(t));
        let num_triangles = order.len();
        order.extend(ghosts);
        self.reorder_faces(&order);
        num_triangles
    }

    /// Calls vertex `v` from now on `names[v]`; the infinite vertex keeps its name.
    ///
    /// # Panics
    /// If a vertex has no new name.
    pub fn rename_vertices(&mut self, names: &[VertexId]) {
        for v in self.corners.as_flattened_mut() {
            if !v.is_infinite() {
                *v = names[v.index()];
            }
        }
    }

    /// Gives `order[i]` the id `i`; faces that do not occur are dropped, and must have no neighbour
    /// that does.
    pub(crate) fn reorder_faces(&mut self, order: &[TriangleId]) {
        let mut new_id = vec![TriangleId::new(0); self.num_faces()];
        for (i, t) in order.iter().enumerate() {
            new_id[t.index()] = TriangleId::new(i);
        }
        let rename = |h: HalfEdgeId| new_id[h.triangle().index()].half_edges()[h.slot()];
        let twins = order.iter().map(|t| self.twins[t.index()].map(rename));
        self.twins = twins.collect();
        self.corners = order.iter().map(|&t| self.corners(t)).collect();
    }

    /// Appends a face whose twins are still to be bonded.
    pub(crate) fn push_face(&mut self, corners: [VertexId; 3]) -> TriangleId {
        let t = TriangleId::new(self.num_faces());
        self.corners.push(corners);
        self.twins.push(t.half_edges());
        t
    }

    /// Drops two faces, which nothing is bonded to.
    fn remove_faces(&mut self, [t, u]: [TriangleId; 2]) -> [Moved; 2] {
        // The higher one first, so that the other cannot be the last one, which moves.
        [t.max(u), t.min(u)].map(|t| self.remove_face(t))
    }

    /// Drops face `t`, which nothing is bonded to, and moves the last face into its place.
    fn remove_face(&mut self, to: TriangleId) -> Moved {
        let from = TriangleId::new(self.num_faces() - 1);
        if to != from {
            self.corners[to.index()] = self.corners(from);
            for (from, to) in from.half_edges().into_iter().zip(to.half_edges()) {
                self.relocate(from, to);
            }
        }
        self.corners.pop();
        self.twins.pop();
        Moved { from, to }
    }

    /// Gives face `t` other corners and leaves its twins as they are: one step of an edit that
    /// rebuilds several faces together, [bonds](Self::bond) them and answers for the sphere itself.
    #[inline]
    pub(crate) fn replace_face(&mut self, t: TriangleId, corners: [VertexId; 3]) {
        self.corners[t.index()] = corners;
    }

    /// Makes `h` and `g` each other's twin.
    #[inline]
    pub(crate) fn bond(&mut self, h: HalfEdgeId, g: HalfEdgeId) {
        self.twins.as_flattened_mut()[h.index()] = g;
        self.twins.as_flattened_mut()[g.index()] = h;
    }

    /// Lets `to` take the place of `from` beside the twin of `from`.
    ///
    /// Several relocations in a row must be done one after the other: the twin of the second may
    /// be the first, as around a vertex of degree two.
    #[inline]
    fn relocate(&mut self, from: HalfEdgeId, to: HalfEdgeId) {
        self.bond(to, self.twin(from));
    }

    #[inline]
    fn set_apex(&mut self, h: HalfEdgeId, v: VertexId) {
        self.corners.as_flattened_mut()[h.index()] = v;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INF: VertexId = VertexId::INFINITE;

    fn v(i: usize) -> VertexId {
        VertexId::new(i)
    }

    /// The half-edge from `a` to `b`.
    fn edge(mesh: &Mesh, a: VertexId, b: VertexId) -> HalfEdgeId {
        mesh.half_edges()
            .find(|&h| mesh.origin(h) == a && mesh.dest(h) == b)
            .unwrap_or_else(|| panic!("no edge {a:?}–{b:?}"))
    }

    /// Corners of all faces, smallest first, sorted.
    fn faces(mesh: &Mesh) -> Vec<[u32; 3]> {
        let mut faces: Vec<_> = mesh.faces().iter().map(|f| f.map(VertexId::raw)).collect();
        for f in &mut faces {
            let smallest = (0..3).min_by_key(|&k| f[k]).expect("three corners");
            f.rotate_left(smallest);
        }
        faces.sort();
        faces
    }

    fn link(mesh: &Mesh, edges: &[HalfEdgeId]) -> Vec<[VertexId; 3]> {
        let triple = |&h: &HalfEdgeId| [mesh.origin(h), mesh.dest(h), mesh.apex(h)];
        edges.iter().map(triple).collect()
    }

    /// Triangle (a, b, c) = (0, 1, 2) with its three ghosts.
    fn triangle() -> Mesh {
        let mut mesh = Mesh::default();
        let ab = mesh.seed(v(0), v(1));
        mesh.split_face(ab.triangle(), v(2));
        mesh.validate().expect("a triangle");
        mesh
    }

    #[test]
    fn seed_is_a_sphere_of_two_ghosts() {
        let mut mesh = triangle();
        let ab = mesh.seed(v(7), v(3));
        mesh.validate().expect("two ghosts");
        assert_eq!((mesh.origin(ab), mesh.dest(ab)), (v(7), v(3)));
        assert_eq!(mesh.num_faces(), 2);
    }

    #[test]
    fn split_face_returns_the_link_and_keeps_ab() {
        let mut mesh = triangle();
        let (a, b, c, p) = (v(0), v(1), v(2), v(3));
        let t = edge(&mesh, a, b).triangle();
        let ab = t.half_edges()[2];
        let [a, b, c] = match mesh.corners(t) {
            corners if corners == [a, b, c] => corners,
            other => panic!("seeded as {other:?}"),
        };
        let edges = mesh.split_face(t, p);
        mesh.validate().expect("split");
        assert_eq!(edges[0], ab);
        assert_eq!(link(&mesh, &edges), [[a, b, p], [b, c, p], [c, a, p]]);
    }

    #[test]
    fn split_ghost_makes_a_triangle_and_two_ghosts() {
        let mut mesh = triangle();
        let ghost = edge(&mesh, v(2), v(1)).triangle();
        assert!(mesh.is_ghost(ghost));
        mesh.split_face(ghost, v(3));
        mesh.validate().expect("split ghost");
        let inf = INF.raw();
        assert_eq!(
            faces(&mesh),
            [
                [0, 1, 2],
                [0, 2, inf],
                [0, inf, 1],
                [1, 3, 2],
                [1, inf, 3],
                [2, 3, inf]
            ]
        );
    }

    #[test]
    fn split_edge_keeps_the_half_edges_at_a() {
        let mut mesh = triangle();
        let (a, b, c, p) = (v(0), v(1), v(2), v(3));
        let h = edge(&mesh, a, b);
        let g = mesh.twin(h);
        let (ca, ad) = (edge(&mesh, c, a), edge(&mesh, a, INF));
        assert_eq!(ad.triangle(), g.triangle());
        let edges = mesh.split_edge(h, p);
        mesh.validate().expect("split edge");
        assert_eq!((mesh.origin(h), mesh.dest(h)), (a, p));
        assert_eq!((mesh.origin(g), mesh.dest(g)), (p, a));
        assert_eq!(edges[..2], [ca, ad]);
        let expected = [[c, a, p], [a, INF, p], [INF, b, p], [b, c, p]];
        assert_eq!(link(&mesh, &edges), expected);
    }

    #[test]
    fn split_edge_works_where_two_faces_share_three_edges() {
        let mut mesh = Mesh::default();
        let h = mesh.seed(v(0), v(1));
        mesh.split_edge(h, v(2));
        mesh.validate().expect("three vertices in a row");
        let inf = INF.raw();
        assert_eq!(
            faces(&mesh),
            [[0, 2, inf], [0, inf, 2], [1, 2, inf], [1, inf, 2]]
        );
    }

    #[test]
    fn open_edge_lengthens_a_row() {
        let mut mesh = Mesh::default();
        let ab = mesh.seed(v(0), v(1));
        let b_inf = ab.next();
        let edges = mesh.open_edge(b_inf, v(2));
        mesh.validate().expect("a row of three");
        assert_eq!(link(&mesh, &edges), [[INF, v(1), v(2)], [v(1), INF, v(2)]]);
        assert_eq!((mesh.origin(b_inf), mesh.dest(b_inf)), (v(1), INF));
        let inf = INF.raw();
        assert_eq!(
            faces(&mesh),
            [[0, 1, inf], [0, inf, 1], [1, 2, inf], [1, inf, 2]]
        );
    }

    #[test]
    fn flip_renames_as_drawn_and_four_times_is_the_identity() {
        let mut mesh = triangle();
        mesh.split_face(edge(&mesh, v(0), v(1)).triangle(), v(3));
        mesh.split_face(edge(&mesh, v(0), v(1)).triangle(), v(4));
        let before = mesh.clone();
        let mut h = edge(&mesh, v(0), v(3));
        let [a, b, c] = [mesh.origin(h), mesh.dest(h), mesh.apex(h)];
        let g = mesh.twin(h);
        let d = mesh.apex(g);
        let (ca, db) = (h.prev(), g.prev());
        mesh.flip(h);
        mesh.validate().expect("flipped");
        assert_eq!(link(&mesh, &[h, g]), [[a, d, c], [b, c, d]]);
        assert_eq!(link(&mesh, &[ca, db]), [[c, a, d], [d, b, c]]);
        assert_eq!(link(&mesh, &[h.next(), g.next()]), [[d, c, a], [c, d, b]]);
        h = h.next();
        for _ in 1..4 {
            mesh.flip(h);
            h = h.next();
        }
        mesh.validate().expect("flipped four times");
        assert_eq!(faces(&mesh), faces(&before));
    }

    #[test]
    fn remove_degree_three_undoes_split_face() {
        for face in 0..4 {
            let mut mesh = triangle();
            let before = faces(&mesh);
            let t = TriangleId::new(face);
            let [a, b, c] = mesh.corners(t);
            mesh.split_face(t, v(3));
            for corner in [a, b, c] {
                let mut mesh = mesh.clone();
                let va = edge(&mesh, v(3), corner);
                let next = mesh.dest(va.next());
                let ab = mesh.remove_degree_three(va);
                mesh.validate().expect("removed");
                assert_eq!((mesh.origin(ab), mesh.dest(ab)), (corner, next));
                assert_eq!(faces(&mesh), before);
            }
        }
    }

    #[test]
    fn contract_undoes_what_grows() {
        for t in 0..4 {
            for k in 0..3 {
                let mesh = triangle();
                let h = HalfEdgeId::new(3 * t + k);
                let [a, b] = [mesh.origin(h), mesh.dest(h)];
                let grow: [&dyn Fn(&mut Mesh); 3] = [
                    &|mesh| assert_eq!(mesh.split_face(h.triangle(), v(3)).len(), 3),
                    &|mesh| assert_eq!(mesh.split_edge(h, v(3)).len(), 4),
                    &|mesh| assert_eq!(mesh.open_edge(h, v(3)).len(), 2),
                ];
                for grow in grow {
                    for target in [a, b] {
                        let mut mesh = mesh.clone();
                        grow(&mut mesh);
                        let spoke = edge(&mesh, v(3), target);
                        let _ = mesh.contract(spoke);
                        mesh.validate().expect("contracted");
                        assert_eq!(faces(&mesh), faces(&triangle()));
                    }
                }
            }
        }
    }

    #[test]
    fn contract_says_which_faces_have_moved() {
        let mut mesh = triangle();
        mesh.split_face(edge(&mesh, v(0), v(1)).triangle(), v(3));
        mesh.split_face(edge(&mesh, v(1), v(0)).triangle(), v(4));
        let before = mesh.clone();
        let h = edge(&mesh, v(3), v(0));
        let gone = [h.triangle(), mesh.twin(h).triangle()];
        let moved = mesh.contract(h);
        for t in (0..before.num_faces()).map(TriangleId::new) {
            if !gone.contains(&t) {
                let now = moved.iter().fold(t, |t, moved| moved.face(t));
                let expected = before.corners(t).map(|w| if w == v(3) { v(0) } else { w });
                assert_eq!(mesh.corners(now), expected);
            }
        }
    }

    #[test]
    fn a_hull_vertex_is_contracted_into_infinity() {
        let mut mesh = triangle();
        mesh.split_face(edge(&mesh, v(2), v(1)).triangle(), v(3));
        let _ = mesh.contract(edge(&mesh, v(3), INF));
        mesh.validate().expect("contracted");
        assert_eq!(faces(&mesh), faces(&triangle()));
    }

    #[test]
    fn a_row_is_shortened_at_its_end_and_inside() {
        for (victim, target) in [(2, 1), (1, 0), (1, 2), (0, 1)] {
            let mut mesh = Mesh::default();
            let ab = mesh.seed(v(0), v(1));
            mesh.open_edge(ab.next(), v(2));
            let spoke = edge(&mesh, v(victim), v(target));
            let _ = mesh.contract(spoke);
            mesh.validate().expect("a row of two");
            assert_eq!(mesh.num_faces(), 2);
        }
    }

    #[test]
    fn fill_joins_a_vertex_to_the_rim() {
        // One, three and five triangles: two too few, enough, two too many.
        for inner in 0..3 {
            let mut mesh = triangle();
            for i in 0..inner {
                mesh.split_face(edge(&mesh, v(0), v(1)).triangle(), v(3 + i));
            }
            let rim = [[1, 0], [2, 1], [0, 2]].map(|[from, to]| edge(&mesh, v(from), v(to)));
            let all = (0..mesh.num_faces()).map(TriangleId::new);
            let mut faces: Vec<_> = all.filter(|&t| !mesh.is_ghost(t)).collect();
            let mut free = Vec::new();
            let spoke = mesh.fill(&mut faces, &rim, &mut free, v(7));
            assert_eq!(
                (faces.len(), free.len()),
                (3, if inner == 2 { 2 } else { 0 })
            );
            assert_eq!(mesh.origin(spoke), v(7));
            assert_eq!(mesh.star(spoke).count(), 3);
            let link = link(&mesh, &rim.map(|h| mesh.twin(h)));
            let expected = [[0, 1, 7], [1, 2, 7], [2, 0, 7]];
            assert_eq!(link, expected.map(|ends| ends.map(v)));
            if inner == 2 {
                // What was left over is taken for the next disc.
                let rim = faces[0].half_edges().map(|h| mesh.twin(h));
                mesh.fill(&mut vec![faces[0]], &rim, &mut free, v(8));
                assert!(free.is_empty());
            }
            mesh.validate().expect("filled");
        }
    }

    #[test]
    fn ghosts_go_last_and_vertices_are_renamed() {
        let mut mesh = triangle();
        mesh.split_face(edge(&mesh, v(2), v(1)).triangle(), v(3));
        assert_eq!(mesh.sort_ghosts_last(), 2);
        mesh.rename_vertices(&[v(10), v(11), v(12), v(13)]);
        mesh.validate().expect("reordered");
        let ghosts = (0..6).map(|t| mesh.is_ghost(TriangleId::new(t)));
        assert_eq!(
            ghosts.collect::<Vec<_>>(),
            [false, false, true, true, true, true]
        );
        assert_eq!(faces(&mesh)[..2], [[10, 11, 12], [10, 12, u32::MAX]]);
    }

    /// Does what `choice` says to half-edge `h`, if it can be done there.
    fn edit(mesh: &mut Mesh, choice: usize, h: HalfEdgeId, new: VertexId) {
        let is_flippable = mesh.apex(h) != mesh.apex(mesh.twin(h));
        let is_removable = !mesh.origin(h).is_infinite() && mesh.star(h).count() == 3;
        match choice {
            0 => assert_eq!(mesh.split_face(h.triangle(), new).len(), 3),
            1 => assert_eq!(mesh.split_edge(h, new)[0], h.prev()),
            2 => {
                let [ba, _] = mesh.open_edge(h, new);
                assert_eq!(mesh.twin(ba), h);
            }
            3..6 if is_flippable => mesh.flip(h),
            6.. if is_removable => {
                let ab = mesh.remove_degree_three(h);
                assert!(ab.triangle().index() < mesh.num_faces());
            }
            _ => {}
        }
    }

    #[test]
    fn any_sequence_of_edits_keeps_the_sphere() {
        let mut state = 1u64;
        let mut below = |bound: usize| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as usize % bound
        };
        for _ in 0..100 {
            let mut mesh = Mesh::default();
            mesh.seed(v(0), v(1));
            for i in 2..100 {
                let h = HalfEdgeId::new(below(3 * mesh.num_faces()));
                let choice = below(12);
                let before = mesh.clone();
                edit(&mut mesh, choice, h, v(i));
                if let Err(error) = mesh.validate() {
                    panic!("edit {choice} at {h:?}: {error}; before: {before:?}");
                }
            }
        }
    }
}
