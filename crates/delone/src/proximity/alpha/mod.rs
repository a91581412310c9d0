//! Alpha shapes (Edelsbrunner, Kirkpatrick and Seidel, *On the shape of a set of points in the plane*,
//! 1983): what is left of the triangulation when an eraser of radius α has gone wherever it meets no
//! point.
//!
//! A triangle belongs to the shape of radius α if its circle's radius is at most α; an edge if it is a
//! side of such a triangle, or if no point lies in or on the circle of which it is a diameter and half of
//! it is at most α; every vertex does. From α = 0, the points alone, to ∞, the convex hull, shapes only
//! grow.
//!
//! *Exact.* Every triangle and edge has a critical radius, stored as the smallest `f64` that is not less
//! than it. So for every α that is an `f64` the comparison is right, although radii are irrational. (Ties
//! on circles are broken by the triangulation, but all triangles of a circle come with one radius.)
//!
//! *Cost*: O(n) to prepare, O(n) a shape, O(n log n) for the lists of radii.

mod shape;

pub use shape::AlphaShape;

use super::Proximity;
use super::forest::Forest;
use crate::predicates::{circumradius_up, half_length_up};
use crate::{Error, HalfEdgeId, TriangleId};

/// The alpha shapes of a point set, for every radius.
///
/// ```
/// use delone::proximity::Proximity;
/// // Two unit squares, 3 apart.
/// let corners = [(0, 0), (1, 0), (1, 1), (0, 1), (4, 0), (5, 0), (5, 1), (4, 1)];
/// let t = delone::triangulate(corners.map(|(x, y)| (f64::from(x), f64::from(y))))?;
/// let proximity = Proximity::new(&t, &())?;
/// let shapes = proximity.alpha_shapes()?;
/// assert_eq!(shapes.shape(0.6)?.singular_edges.len(), 8);
/// let shape = shapes.shape(1.0)?;
/// assert_eq!((shape.triangles.len(), shape.boundary.len()), (4, 2));
/// assert_eq!(shapes.connecting_radius()?, 1.5);
/// assert_eq!(shapes.solid_radius()?, Some(2.5_f64.sqrt()));
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone)]
pub struct AlphaShapes<'p> {
    proximity: &'p Proximity<'p>,
    /// The critical radius of each face; infinite for ghosts.
    faces: Vec<f64>,
    /// One half-edge of each edge, with the critical radius of the edge.
    edges: Vec<(HalfEdgeId, f64)>,
}

impl Proximity<'_> {
    /// Prepares the alpha shapes.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n).
    pub fn alpha_shapes(&self) -> Result<AlphaShapes<'_>, Error> {
        let mesh = self.triangulation.mesh();
        let mut pace = self.pace();
        let mut faces = Vec::with_capacity(mesh.num_faces());
        for corners in mesh.faces() {
            pace.step()?;
            faces.push(if corners.iter().any(|v| v.is_infinite()) {
                f64::INFINITY
            } else {
                let [a, b, c] = corners.map(|v| self.point(v));
                circumradius_up(a, b, c)
            });
        }
        let mut edges = Vec::new();
        for h in self.half_edges() {
            pace.step()?;
            let radius = if self.is_gabriel(h) {
                half_length_up(self.end_points(h))
            } else {
                let [left, right] = [h, mesh.twin(h)].map(|h| faces[h.triangle().index()]);
                left.min(right)
            };
            edges.push((h, radius));
        }
        pace.finish();
        Ok(AlphaShapes {
            proximity: self,
            faces,
            edges,
        })
    }
}

impl AlphaShapes<'_> {
    /// Returns whose shapes these are.
    pub fn proximity(&self) -> &Proximity<'_> {
        self.proximity
    }

    /// Returns the radius from which on a triangle of [`Proximity::triangulation`] belongs to the shape:
    /// that of its circle, [rounded up](circumradius_up).
    ///
    /// # Panics
    /// If there is no such triangle.
    pub fn radius_of(&self, t: TriangleId) -> f64 {
        self.faces[t.index()]
    }

    /// Lists all radii at which the shape changes, ascending, each once, rounded up.
    ///
    /// *Cost*: O(n log n).
    pub fn critical_radii(&self) -> Vec<f64> {
        let of_edges = self.edges.iter().map(|&(_, radius)| radius);
        let of_faces = self.triangles().map(|t| self.radius_of(t));
        let mut radii: Vec<f64> = of_edges.chain(of_faces).collect();
        radii.sort_unstable_by(f64::total_cmp);
        radii.dedup();
        radii
    }

    /// Returns the smallest radius whose shape is connected and has every vertex in it, edges without
    /// triangles counted: half the longest edge of the [spanning tree](Proximity::spanning_tree), rounded
    /// up. 0 for fewer than two vertices.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n log n).
    pub fn connecting_radius(&self) -> Result<f64, Error> {
        let tree = self.proximity.spanning_tree()?;
        let longest = tree.half_edges().last();
        Ok(longest.map_or(0.0, |&h| half_length_up(self.proximity.end_points(h))))
    }

    /// Returns the smallest radius whose triangles form one piece, joined across edges, that touches
    /// every vertex; rounded up. `None` if there is no triangle.
    ///
    /// A larger radius may add a triangle apart from the piece, until its surroundings follow.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n log n).
    pub fn solid_radius(&self) -> Result<Option<f64>, Error> {
        let mut triangles: Vec<TriangleId> = self.triangles().collect();
        let by_radius = |&s: &TriangleId, &t: &TriangleId| {
            let radii = self.radius_of(s).total_cmp(&self.radius_of(t));
            radii.then(s.cmp(&t))
        };
        triangles.sort_unstable_by(by_radius);
        let mut growth = Growth::new(self);
        let mut pace = self.proximity.pace();
        for group in triangles.chunk_by(|&s, &t| self.radius_of(s) == self.radius_of(t)) {
            for &t in group {
                pace.step()?;
                growth.add(t);
            }
            if growth.is_solid() {
                return Ok(Some(self.radius_of(group[0])));
            }
        }
        Ok(None)
    }

    /// Returns the shape of radius `alpha`, which may be infinite.
    ///
    /// # Errors
    /// [`Error::BadRadius`] if `alpha` is negative or NaN; [`Error::Cancelled`].
    ///
    /// *Cost*: O(n).
    pub fn shape(&self, alpha: f64) -> Result<AlphaShape, Error> {
        if alpha.is_nan() || alpha < 0.0 {
            return Err(Error::BadRadius { given: alpha });
        }
        shape::of_radius(self, alpha)
    }

    fn triangles(&self) -> impl Iterator<Item = TriangleId> + '_ {
        self.proximity.triangulation.mesh().triangles()
    }
}

/// Triangles, one after the other, and the pieces that they form.
struct Growth<'a> {
    shapes: &'a AlphaShapes<'a>,
    has: Vec<bool>,
    touched: Vec<bool>,
    forest: Forest,
    pieces: usize,
    untouched: usize,
}

impl<'a> Growth<'a> {
    fn new(shapes: &'a AlphaShapes<'a>) -> Self {
        let t = shapes.proximity.triangulation();
        Self {
            shapes,
            has: vec![false; shapes.faces.len()],
            touched: vec![false; t.points().len()],
            forest: Forest::new(shapes.faces.len()),
            pieces: 0,
            untouched: t.num_vertices(),
        }
    }

    fn add(&mut self, t: TriangleId) {
        let mesh = self.shapes.proximity.triangulation.mesh();
        self.has[t.index()] = true;
        self.pieces += 1;
        for h in t.half_edges() {
            let beyond = mesh.twin(h).triangle();
            if self.has[beyond.index()] && self.forest.join(t.index(), beyond.index()) {
                self.pieces -= 1;
            }
            let corner = &mut self.touched[mesh.apex(h).index()];
            self.untouched -= usize::from(!*corner);
            *corner = true;
        }
    }

    fn is_solid(&self) -> bool {
        self.pieces == 1 && self.untouched == 0
    }
}
