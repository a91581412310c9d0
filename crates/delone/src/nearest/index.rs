//! Nearest neighbours of any points, one by one or many at once.

use super::graph::Graph;
use super::search::Scratch;
use crate::delaunay::of_vertices;
use crate::locate::{Spread, Tree, check_finite};
use crate::{Delaunay, Error, Phase, Point, Triangulation, VertexId, Watch};

/// Finds the vertices of a triangulation that are nearest to a point.
///
/// Of equal points the one of lowest index stands for all. Every comparison of distances is exact, and equal
/// ones are ordered by index.
///
/// ```
/// use delone::nearest::Nearest;
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (1.0, 1.0)];
/// let nearest = Nearest::of_points(points, &())?;
/// assert_eq!(nearest.nearest((3.0, 2.9))?, Some(2.into()));
/// assert_eq!(nearest.k_nearest((2.0, 1.5), 3)?, [4, 0, 1].map(Into::into)); // 0 to 3 are equally near
/// assert_eq!(nearest.within((0.0, 0.0), 4.0)?, [0, 1, 3, 4].map(Into::into)); // the border counts
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Nearest {
    graph: Graph,
    /// Where to begin; `None` if there are no vertices.
    entrance: Option<(Tree, Spread)>,
    threads: Option<usize>,
}

impl Nearest {
    /// Prepares for queries about the vertices of a triangulation, bare, constrained, carved or refined:
    /// all of them, those in no triangle of the domain, too.
    ///
    /// A triangulation that constraints keep from being Delaunay is tested for it, and that of its vertices
    /// is built in its place; `watch` is told of that.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
    ///
    /// *Cost*: linear, about half of triangulating, and a triangulation more if one is to be built.
    pub fn new(triangulation: &Triangulation, watch: &dyn Watch) -> Result<Self, Error> {
        Self::on(&*of_vertices(triangulation, watch)?, watch)
    }

    /// Prepares for queries about points, which are triangulated for it.
    ///
    /// # Errors
    /// As [`Delaunay::triangulate`].
    pub fn of_points<P: Into<Point>>(
        points: impl IntoIterator<Item = P>,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        let t = Delaunay::new().watch(watch).triangulate(points)?;
        Self::on(&t, watch)
    }

    /// Prepares for queries about the vertices of a Delaunay triangulation.
    fn on(t: &Triangulation, watch: &dyn Watch) -> Result<Self, Error> {
        let graph = Graph::new(t, watch)?;
        let n = graph.points.len();
        let entrance = (n > 0).then(|| {
            let tree = Tree::sample(n, |v| graph.points[v]);
            (tree, Spread::around(&graph.points))
        });
        Ok(Self {
            graph,
            entrance,
            threads: None,
        })
    }

    /// Uses `threads` threads for many queries at once (0 means 1, and at most 1024; all of the machine if
    /// never called). The answers are the same for any number.
    pub fn threads(self, threads: usize) -> Self {
        Self {
            threads: Some(threads),
            ..self
        }
    }

    /// Returns the vertex nearest to `point`, of several the one of lowest index; `None` if there is no
    /// vertex.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite.
    ///
    /// *Cost*: O(log n), and in practice a few vertices.
    pub fn nearest(&self, point: impl Into<Point>) -> Result<Option<VertexId>, Error> {
        self.one(point.into(), |_, nearest, _| Some(self.name(nearest)))
    }

    /// Lists the `k` vertices nearest to `point`, or all if they are fewer: by distance, equal ones by index.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite.
    ///
    /// *Cost*: as [`nearest`](Self::nearest), and O(k log k) if vertices have few neighbours; of those as near
    /// as the last, all are looked at.
    pub fn k_nearest(&self, point: impl Into<Point>, k: usize) -> Result<Vec<VertexId>, Error> {
        self.one(point.into(), |p, nearest, scratch| {
            self.graph.k_nearest(p, nearest, k, scratch)
        })
    }

    /// Lists the vertices whose distance from `point` is at most `radius`, by index. The distance is that of
    /// the plane, not a rounded one: its square is compared with the square of `radius` exactly.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if a coordinate is NaN or infinite, [`Error::BadRadius`] if the radius is, or
    /// negative.
    ///
    /// *Cost*: as [`nearest`](Self::nearest), and O(m log m) for m vertices found that have few neighbours.
    pub fn within(&self, point: impl Into<Point>, radius: f64) -> Result<Vec<VertexId>, Error> {
        check_radius(radius)?;
        self.one(point.into(), |p, nearest, scratch| {
            self.graph.within(p, nearest, radius, scratch)
        })
    }

    /// Finds the vertex [nearest](Self::nearest) to each of `points`, in their order. `watch` is told of
    /// [`Phase::Query`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] names the first point with a coordinate that is NaN or infinite;
    /// [`Error::Cancelled`] if the watch says so; [`Error::Threads`] if they cannot be started.
    pub fn nearest_all(
        &self,
        points: &[Point],
        watch: &dyn Watch,
    ) -> Result<Vec<Option<VertexId>>, Error> {
        self.all(points, watch, |_, nearest, _| Some(self.name(nearest)))
    }

    /// Lists the [`k` nearest](Self::k_nearest) vertices of each of `points`, in their order.
    ///
    /// # Errors
    /// As [`nearest_all`](Self::nearest_all).
    pub fn k_nearest_all(
        &self,
        points: &[Point],
        k: usize,
        watch: &dyn Watch,
    ) -> Result<Vec<Vec<VertexId>>, Error> {
        self.all(points, watch, |p, nearest, scratch| {
            self.graph.k_nearest(p, nearest, k, scratch)
        })
    }

    /// Lists the vertices [within](Self::within) `radius` of each of `points`, in their order.
    ///
    /// # Errors
    /// As [`nearest_all`](Self::nearest_all), and [`Error::BadRadius`].
    pub fn within_all(
        &self,
        points: &[Point],
        radius: f64,
        watch: &dyn Watch,
    ) -> Result<Vec<Vec<VertexId>>, Error> {
        check_radius(radius)?;
        self.all(points, watch, |p, nearest, scratch| {
            self.graph.within(p, nearest, radius, scratch)
        })
    }

    /// Answers one query from the vertex nearest to it.
    fn one<A: Default>(
        &self,
        point: Point,
        answer: impl Fn(Point, u32, &mut Scratch) -> A,
    ) -> Result<A, Error> {
        check_finite(&[point])?;
        let Some((tree, _)) = &self.entrance else {
            return Ok(A::default());
        };
        let scratch = &mut Scratch::default();
        let nearest = self.graph.nearest(point, tree.near(point), scratch);
        Ok(answer(point, nearest, scratch))
    }

    /// Answers many queries, each from the vertex nearest to it.
    fn all<A: Default + Send>(
        &self,
        points: &[Point],
        watch: &dyn Watch,
        answer: impl Fn(Point, u32, &mut Scratch) -> A + Sync,
    ) -> Result<Vec<A>, Error> {
        check_finite(points)?;
        let Some((tree, spread)) = &self.entrance else {
            return Ok(points.iter().map(|_| A::default()).collect());
        };
        let begin = || (None, Scratch::default());
        let answer_next = |(last, scratch): &mut (Option<u32>, Scratch), p| {
            let start = last.filter(|&v| self.graph.is_close(v, p));
            let start = start.unwrap_or_else(|| tree.near(p));
            let nearest = self.graph.nearest(p, start, scratch);
            *last = Some(nearest);
            answer(p, nearest, scratch)
        };
        let watched = (watch, Phase::Query);
        spread.answer(points, self.threads, watched, begin, answer_next)
    }

    fn name(&self, v: u32) -> VertexId {
        self.graph.names[v as usize]
    }
}

fn check_radius(given: f64) -> Result<(), Error> {
    if given.is_finite() && given >= 0.0 {
        Ok(())
    } else {
        Err(Error::BadRadius { given })
    }
}
