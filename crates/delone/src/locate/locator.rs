//! Location in a whole triangulation.

use super::Location;
use super::batch::{Spread, check_finite};
use super::rim::{Rim, Row};
use super::tree::Tree;
use super::walk::{Walk, inner};
use crate::memory::fetch_ahead;
use crate::pace::Pace;
use crate::predicates::squared_length;
use crate::{Error, HalfEdgeId, Mesh, Phase, Point, TriangleId, Triangulation, VertexId, Watch};
use std::ops::Range;

/// Says where points lie in a triangulation, bare, constrained, carved or refined.
///
/// ```
/// use delone::locate::{Location, Locator};
///
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 2.0)])?;
/// let locator = Locator::new(&t);
/// assert_eq!(locator.locate((1.0, 2.0))?, Location::Vertex(4.into()));
/// assert!(matches!(locator.locate((3.0, 0.0))?, Location::Edge(_)));
/// assert!(matches!(locator.locate((5.0, 2.0))?, Location::Outside(_)));
///
/// // A triangle for each of many points: corners and edges belong to it.
/// let asked = [(3.0, 3.0), (3.0, 0.0), (9.0, 9.0)].map(Into::into);
/// let found = locator.locate_all(&asked, &())?;
/// let triangles: Vec<_> = found.iter().map(|location| location.triangle(&t)).collect();
/// assert!(triangles[0].is_some() && triangles[1].is_some() && triangles[2].is_none());
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Locator<'t> {
    triangulation: &'t Triangulation,
    shape: Shape,
    threads: Option<usize>,
}

/// What there is to walk on.
#[derive(Clone, Debug)]
enum Shape {
    /// At most one vertex.
    Apart,
    /// All vertices on one line.
    Row(Row),
    /// Triangles.
    Plane(Plane),
}

#[derive(Clone, Debug)]
struct Plane {
    rim: Rim,
    /// Of the finite faces.
    tree: Tree,
    spread: Spread,
}

impl<'t> Locator<'t> {
    /// Prepares for queries on `triangulation`.
    ///
    /// *Cost*: O(m log m) for a sample of m = n/8 triangles, a few milliseconds for a million points.
    pub fn new(triangulation: &'t Triangulation) -> Self {
        let (mesh, points) = (triangulation.mesh(), triangulation.points());
        let shape = if mesh.num_faces() == 0 {
            Shape::Apart
        } else if triangulation.num_finite() == 0 {
            Shape::Row(Row::new(mesh, points))
        } else {
            Shape::Plane(Plane::new(triangulation))
        };
        Self {
            triangulation,
            shape,
            threads: None,
        }
    }

    /// Uses `threads` threads for [`locate_all`](Self::locate_all) (0 means 1, and at most 1024; all of the
    /// machine if never called). The answers are the same for any number.
    pub fn threads(self, threads: usize) -> Self {
        Self {
            threads: Some(threads),
            ..self
        }
    }

    /// Finds where `point` lies. The answer depends on the triangulation and the point alone.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite.
    ///
    /// *Cost*: O(log n), and a short walk; see the [module](super).
    pub fn locate(&self, point: impl Into<Point>) -> Result<Location, Error> {
        let point = point.into();
        check_finite(&[point])?;
        Ok(match &self.shape {
            Shape::Plane(plane) => self.walk(plane, self.start(plane, point), point).0,
            _ => self.without_triangles(point),
        })
    }

    /// As [`locate`](Self::locate), walking from the face of `hint` instead of jumping: for a point near
    /// to one that is located already.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite.
    ///
    /// # Panics
    /// If `hint` is no half-edge of the mesh.
    ///
    /// *Cost*: one or two orientation tests for each triangle in between.
    pub fn locate_from(
        &self,
        hint: HalfEdgeId,
        point: impl Into<Point>,
    ) -> Result<Location, Error> {
        let point = point.into();
        check_finite(&[point])?;
        Ok(match (&self.shape, inner(self.mesh(), hint)) {
            (Shape::Plane(plane), Some(start)) => self.walk(plane, start, point).0,
            _ => self.without_triangles(point),
        })
    }

    /// Finds where each of `points` lies; the answers come in their order, and are those of
    /// [`locate`](Self::locate). `watch` is told of [`Phase::Query`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] names the first point with a coordinate that is NaN or infinite;
    /// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
    ///
    /// *Cost*: points are sorted along a space-filling curve, each walks from the one before or jumps: a
    /// tenth of a microsecond where there are as many of them as vertices; 16 bytes a point beside the
    /// answers.
    pub fn locate_all(&self, points: &[Point], watch: &dyn Watch) -> Result<Vec<Location>, Error> {
        check_finite(points)?;
        let Shape::Plane(plane) = &self.shape else {
            return self.all_without_triangles(points, watch);
        };
        let answer = |last: &mut Trail, p| {
            let start = match last.end {
                Some(h) if self.is_close(h, p) => h,
                _ => self.start(plane, p),
            };
            let (location, end) = self.walk(plane, start, p);
            last.end = Some(end);
            last.ahead.read(self.triangulation, end.triangle());
            location
        };
        let watched = (watch, Phase::Query);
        plane
            .spread
            .answer(points, self.threads, watched, Trail::default, answer)
    }

    /// Tells whether it is a few triangles only from the edge of `h` to `p`, as far as its length tells.
    fn is_close(&self, h: HalfEdgeId, p: Point) -> bool {
        let [a, b] =
            [self.mesh().origin(h), self.mesh().dest(h)].map(|v| self.triangulation.point(v));
        squared_length([a, p]) <= 16.0 * squared_length([a, b])
    }

    /// Walks from a half-edge of a finite face, and chooses among names for the same place. Returns a
    /// half-edge of a finite face nearby as well.
    #[inline]
    fn walk(&self, plane: &Plane, start: HalfEdgeId, goal: Point) -> (Location, HalfEdgeId) {
        let (mesh, points) = (self.mesh(), self.triangulation.points());
        let walk = Walk { mesh, points, goal };
        let (found, end) = walk.through_triangles(start);
        let location = match found {
            Location::Face(t) if t.index() >= self.triangulation.num_triangles() => {
                Location::Carved(t)
            }
            Location::Edge(h) => Location::Edge(h.min(mesh.twin(h))),
            Location::Outside(_) => Location::Outside(plane.rim.towards(mesh, points, goal)),
            other => other,
        };
        (location, end)
    }

    fn start(&self, plane: &Plane, point: Point) -> HalfEdgeId {
        face_of(plane.tree.near(point))
    }

    fn without_triangles(&self, point: Point) -> Location {
        let points = self.triangulation.points();
        match &self.shape {
            Shape::Row(row) => row.locate(self.mesh(), points, point),
            _ if points.first() == Some(&point) => Location::Vertex(VertexId::new(0)),
            _ => Location::Apart,
        }
    }

    fn all_without_triangles(
        &self,
        points: &[Point],
        watch: &dyn Watch,
    ) -> Result<Vec<Location>, Error> {
        let mut pace = Pace::new(watch, Phase::Query, points.len() as u64);
        let answers = points.iter().map(|&p| {
            pace.step()?;
            Ok(self.without_triangles(p))
        });
        let answers = answers.collect::<Result<_, _>>()?;
        pace.finish();
        Ok(answers)
    }

    fn mesh(&self) -> &'t Mesh {
        self.triangulation.mesh()
    }
}

impl Plane {
    fn new(t: &Triangulation) -> Self {
        let (mesh, points) = (t.mesh(), t.points());
        let ghost = TriangleId::new(t.num_finite());
        let rim = Rim::new(mesh, points, mesh.hull_edge_of(ghost));
        let corner = |face: usize| points[mesh.corners(TriangleId::new(face))[0].index()];
        Self {
            tree: Tree::sample(t.num_finite(), corner),
            spread: Spread::around(rim.vertices(mesh, points)),
            rim,
        }
    }
}

/// What a query leaves for the next one.
#[derive(Default)]
struct Trail {
    end: Option<HalfEdgeId>,
    ahead: ReadAhead,
}

/// Fetches the corners of triangles before they are needed: vertices lie in memory as the caller gave them,
/// so each is a long way to go, but many ways can be gone at once. Builders number triangles along a
/// space-filling curve, so queries sorted along one mostly come to those of higher numbers next.
#[derive(Default)]
struct ReadAhead {
    known: Range<usize>,
    queries: usize,
    read: usize,
}

impl ReadAhead {
    /// Triangles whose corners are fetched at once.
    const WINDOW: usize = 128;
    /// Triangles that may be read for each query: with fewer queries, or in another order, it is in vain.
    const A_QUERY: usize = 4;

    /// Reads those from `t` on, if a query has come to one that is not known.
    #[inline]
    fn read(&mut self, triangulation: &Triangulation, t: TriangleId) {
        self.queries += 1;
        if !self.known.contains(&t.index()) && self.read <= Self::A_QUERY * self.queries {
            self.read_window(triangulation, t.index());
        }
    }

    #[cold]
    fn read_window(&mut self, triangulation: &Triangulation, first: usize) {
        self.known = first..(first + Self::WINDOW).min(triangulation.num_finite());
        self.read += Self::WINDOW;
        let corners = &triangulation.mesh().faces()[self.known.clone()];
        for v in corners.as_flattened() {
            fetch_ahead(&triangulation.points()[v.index()]);
        }
    }
}

fn face_of(item: u32) -> HalfEdgeId {
    TriangleId::from(item).half_edges()[0]
}
