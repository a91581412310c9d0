//! The second builder: one point at a time, located by walking and legalised by flips.
//!
//! Lawson, *Software for C¹ surface interpolation*, 1977. It is the oracle of the bulk builder: it
//! shares no idea with divide and conquer, and yields the identical triangulation for every order of
//! insertion. What an insertion does stands in `insertion.rs`, which [live editing](crate::edit) calls,
//! too; that keeps more beside the mesh, and finds places faster.
//!
//! Cost: an insertion costs its walk (see [`locate`](crate::locate::locate)) and one flip for every
//! edge but three that the new vertex ends up with; O(n) at worst, constant flips on average in
//! random order. Points of one line in random order cost O(n) each, as the walk has no short cuts.

use super::insertion::{self, Growing};
use crate::locate::locate;
use crate::{Duplicate, Error, HalfEdgeId, Mesh, Point, TriangleId, Triangulation, VertexId};

/// What became of a point that was given to be inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Inserted {
    /// It is a new vertex.
    Vertex(VertexId),
    /// It equals an earlier point, whose vertex stands for it.
    Duplicate(VertexId),
}

impl Inserted {
    /// Returns the vertex that is there now.
    pub fn vertex(self) -> VertexId {
        match self {
            Self::Vertex(v) | Self::Duplicate(v) => v,
        }
    }
}

/// A Delaunay triangulation that grows by single points.
///
/// Point `i` inserted is vertex `i`, unless it equals an earlier one.
///
/// ```
/// use delone::{Point, delaunay::{Incremental, Inserted}};
/// let mut growing = Incremental::new();
/// for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
///     growing.insert(Point::new(x, y))?;
/// }
/// let again = growing.insert(Point::new(1.0, 0.0))?;
/// assert!(matches!(again, Inserted::Duplicate(v) if v.index() == 1));
/// assert_eq!(growing.finish().num_triangles(), 2);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Incremental {
    plain: Plain,
    /// In the order of insertion; `kept` is the point inserted first.
    duplicates: Vec<Duplicate>,
    /// Where the next walk begins.
    hint: HalfEdgeId,
    /// Half-edges opposite the new vertex that may have to be flipped.
    suspects: Vec<HalfEdgeId>,
}

/// Points and mesh, and nothing else that edits would have to keep.
#[derive(Clone, Debug, Default)]
struct Plain {
    points: Vec<Point>,
    mesh: Mesh,
}

impl Growing for Plain {
    fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    fn point(&self, v: VertexId) -> Point {
        self.points[v.index()]
    }

    fn is_locked(&self, _: HalfEdgeId) -> bool {
        false
    }

    fn split_face(&mut self, t: TriangleId, v: VertexId) -> [HalfEdgeId; 3] {
        self.mesh.split_face(t, v)
    }

    fn split_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 4] {
        self.mesh.split_edge(h, v)
    }

    fn open_edge(&mut self, h: HalfEdgeId, v: VertexId) -> [HalfEdgeId; 2] {
        self.mesh.open_edge(h, v)
    }

    fn flip(&mut self, h: HalfEdgeId) {
        self.mesh.flip(h);
    }
}

impl Default for Incremental {
    fn default() -> Self {
        Self::new()
    }
}

impl Incremental {
    /// Starts without points.
    pub fn new() -> Self {
        Self {
            plain: Plain::default(),
            duplicates: Vec::new(),
            hint: HalfEdgeId::new(0),
            suspects: Vec::new(),
        }
    }

    /// Triangulates `points`, inserting them in the given order; the result is the same for every
    /// one.
    ///
    /// # Errors
    /// As [`triangulate`](super::triangulate).
    ///
    /// # Panics
    /// If `order` is not a permutation of the indices of `points`.
    pub fn triangulate_in_order(points: &[Point], order: &[usize]) -> Result<Triangulation, Error> {
        assert_eq!(order.len(), points.len(), "the order is not a permutation");
        for (index, &p) in points.iter().enumerate() {
            check_finite(index, p)?;
        }
        let mut growing = Self::new();
        for &i in order {
            growing.insert(points[i])?;
        }
        Ok(growing.finish_as(order))
    }

    /// Counts the points inserted, duplicates included.
    pub fn num_points(&self) -> usize {
        self.plain.points.len()
    }

    /// Returns the mesh so far, triangles and ghosts in no particular order; empty before two
    /// distinct points.
    pub fn mesh(&self) -> &Mesh {
        &self.plain.mesh
    }

    /// Inserts a point.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite, with the number of points before as
    /// index; [`Error::TooManyPoints`] if ids would not fit 32 bits. The triangulation is then
    /// unchanged.
    ///
    /// *Cost*: the walk from the point inserted before, and one flip for every edge but three that
    /// the new vertex ends up with. *Ids invalidated*: half-edges and faces; vertices keep theirs.
    pub fn insert(&mut self, point: Point) -> Result<Inserted, Error> {
        let index = self.plain.points.len();
        check_finite(index, point)?;
        super::bulk::check_number(index + 1)?;
        // Adding zero turns −0.0 into 0.0.
        let point = Point::new(point.x + 0.0, point.y + 0.0);
        let vertex = VertexId::new(index);
        self.plain.points.push(point);
        let Err(kept) = self.place(vertex, point) else {
            return Ok(Inserted::Vertex(vertex));
        };
        let dropped = vertex;
        self.duplicates.push(Duplicate { dropped, kept });
        Ok(Inserted::Duplicate(kept))
    }

    /// Hands over the triangulation; point `i` inserted is point `i` of the result.
    pub fn finish(self) -> Triangulation {
        let order: Vec<_> = (0..self.plain.points.len()).collect();
        self.finish_as(&order)
    }

    /// Makes `vertex` part of the triangulation, or returns the vertex that lies there already.
    fn place(&mut self, vertex: VertexId, point: Point) -> Result<(), VertexId> {
        if self.mesh().num_faces() == 0 {
            return self.place_early(vertex, point);
        }
        let at = locate(self.mesh(), &self.plain.points, self.hint, point);
        self.hint = insertion::insert(&mut self.plain, at, vertex, &mut self.suspects)?;
        Ok(())
    }

    /// As [`place`](Self::place), while there is at most one vertex.
    fn place_early(&mut self, vertex: VertexId, point: Point) -> Result<(), VertexId> {
        let first = VertexId::new(0);
        if vertex == first {
            return Ok(());
        }
        if self.plain.point(first) == point {
            return Err(first);
        }
        self.hint = self.plain.mesh.seed(first, vertex);
        Ok(())
    }

    /// Hands over the triangulation; point `i` inserted is point `order[i]` of the result.
    fn finish_as(self, order: &[usize]) -> Triangulation {
        let (names, duplicates) = self.names(order);
        let mut points = self.plain.points.clone();
        for (&i, &p) in order.iter().zip(&self.plain.points) {
            points[i] = p;
        }
        let mut mesh = self.plain.mesh;
        mesh.rename_vertices(&names);
        let num_triangles = mesh.sort_ghosts_last();
        Triangulation::from_parts(points, mesh, num_triangles, duplicates)
    }

    /// Names the vertex of each point inserted by the lowest of the numbers that `order` gives to
    /// equal points, and lists the others.
    fn names(&self, order: &[usize]) -> (Vec<VertexId>, Vec<Duplicate>) {
        let given = |v: VertexId| VertexId::new(order[v.index()]);
        let mut names: Vec<_> = order.iter().map(|&i| VertexId::new(i)).collect();
        for d in &self.duplicates {
            let name = &mut names[d.kept.index()];
            *name = given(d.dropped).min(*name);
        }
        let mut duplicates = Vec::with_capacity(self.duplicates.len());
        for d in &self.duplicates {
            let kept = names[d.kept.index()];
            for dropped in [given(d.dropped), given(d.kept)] {
                if dropped != kept {
                    duplicates.push(Duplicate { dropped, kept });
                }
            }
        }
        duplicates.sort_unstable_by_key(|d| d.dropped);
        // The point inserted first was listed once for every duplicate of it.
        duplicates.dedup();
        (names, duplicates)
    }
}

fn check_finite(index: usize, p: Point) -> Result<(), Error> {
    if p.is_finite() {
        return Ok(());
    }
    let Point { x, y } = p;
    Err(Error::NotFinite { index, x, y })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grow(points: &[(f64, f64)]) -> Incremental {
        let mut growing = Incremental::new();
        for &p in points {
            growing.insert(p.into()).expect("finite points");
            growing
                .mesh()
                .validate()
                .expect("a sphere after every point");
        }
        growing
    }

    #[test]
    fn few_points_are_defined() {
        assert_eq!(grow(&[]).finish().num_vertices(), 0);
        let one = grow(&[(3.0, 4.0); 3]).finish();
        assert_eq!((one.num_vertices(), one.mesh().num_faces()), (1, 0));
        assert_eq!(one.representative(VertexId::new(2)), VertexId::new(0));
        let two = grow(&[(0.0, 0.0), (1.0, 1.0)]).finish();
        assert_eq!((two.num_triangles(), two.mesh().num_faces()), (0, 2));
        assert_eq!(two.num_edges(), 1);
    }

    #[test]
    fn a_row_has_two_ghosts_an_edge_in_any_order() {
        let row = [(3.0, 3.0), (1.0, 1.0), (4.0, 4.0), (2.0, 2.0), (0.0, 0.0)];
        let t = grow(&row).finish();
        assert_eq!((t.num_triangles(), t.mesh().num_faces()), (0, 8));
        assert_eq!((t.num_edges(), t.num_hull_edges()), (4, 4));
        let mut edges: Vec<_> = t.edges().map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort();
        let expected = [[0, 2], [0, 3], [1, 3], [1, 4]].map(|e| e.map(VertexId::new));
        assert_eq!(edges, expected);
    }

    #[test]
    fn a_point_off_the_line_lifts_the_row_on_either_side() {
        for side in [1.0, -1.0] {
            let mut points: Vec<_> = (0..5).map(|i| (f64::from(i), 0.0)).collect();
            points.push((1.5, side));
            let t = grow(&points).finish();
            assert_eq!((t.num_triangles(), t.num_hull_edges()), (4, 6));
            let apex = VertexId::new(5);
            assert!(t.triangles().iter().all(|corners| corners.contains(&apex)));
        }
    }

    #[test]
    fn the_diagonal_of_a_square_avoids_its_largest_corner() {
        let t = grow(&[(1.0, 1.0), (0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]).finish();
        let largest = VertexId::new(0);
        let touching = t.triangles().iter().filter(|c| c.contains(&largest));
        assert_eq!(touching.count(), 1);
    }

    #[test]
    fn duplicates_go_to_the_lowest_index_of_the_caller() {
        let (a, b, c) = ((0.0, 0.0), (1.0, 0.0), (0.0, -0.0));
        let points = [b, a, c, b, a, b].map(Point::from);
        let t = Incremental::triangulate_in_order(&points, &[5, 4, 3, 2, 1, 0]).expect("finite");
        let pairs: Vec<_> = t.duplicates().iter().map(|d| [d.dropped, d.kept]).collect();
        let expected = [[2, 1], [3, 0], [4, 1], [5, 0]].map(|pair| pair.map(VertexId::new));
        assert_eq!(pairs, expected);
        assert_eq!(t.num_vertices(), 2);
        assert!(
            t.mesh()
                .faces()
                .iter()
                .all(|f| f.contains(&VertexId::new(0)))
        );
    }

    #[test]
    fn what_is_not_finite_is_refused_and_forgotten() {
        let mut growing = grow(&[(0.0, 0.0), (1.0, 0.0)]);
        let error = growing.insert(Point::new(f64::NAN, 0.0));
        assert!(matches!(error, Err(Error::NotFinite { index: 2, .. })));
        assert_eq!(growing.num_points(), 2);
        let inserted = growing.insert(Point::new(0.0, 1.0));
        assert_eq!(inserted, Ok(Inserted::Vertex(VertexId::new(2))));
        assert_eq!(growing.finish().num_triangles(), 1);
    }
}
