//! Weighted points: the regular triangulation, whose dual is the power diagram.
//!
//! ```text
//! sites ── order ──> distinct sites, best weight of each place, in rounds ── insert, cavity ──> mesh
//!                                                     └─ row, if all are collinear ────────────> mesh
//! ```
//!
//! A site is a point with a weight, which makes it stronger: the *power* of a place q with respect to
//! it is |q − p|² − weight, and the [power diagram](crate::voronoi::Voronoi::weighted) gives each place to
//! the site of least power (Aurenhammer 1987). If the
//! weights are squared radii, sites are circles. Two sites are joined by an edge of the regular
//! triangulation where their cells touch. A site may be *hidden*: its cell is empty, it is no vertex.
//! With equal weights all of this is the Delaunay triangulation and the Voronoi diagram.
//!
//! **One result.** Lift each site to the height |p|² − weight: the triangles are the lower convex hull
//! seen from below. The symbolic perturbation of the Delaunay triangulation breaks all ties, those with
//! collinear points included (`predicates/perturbation.rs` has the proof), so that a set of sites has
//! exactly one regular triangulation, whatever the order. In each place the heaviest site counts, of
//! equally heavy ones that of lowest index. A site exactly on the edge or triangle below it is a vertex:
//! hidden are only those that lie strictly above.
//!
//! **How.** Insertion one by one after Bowyer (1981) and Watson (1981), in rounds of random sites of
//! which each is four times the one before (Amenta, Choi and Rote 2003) and follows a space-filling
//! curve. Flips alone could get stuck before a triangulation is regular (Edelsbrunner and Shah 1996);
//! the conflict zone of a new site cannot: seen as part of a convex hull it is a disc, in which some
//! vertices may vanish. A walk ends, because regular triangulations are acyclic (Edelsbrunner 1990).
//!
//! *Cost*: about five times that of the Delaunay triangulation on one thread for evenly spread points
//! and radii. Conflicts are O(n) in all, expected, for every input; walks are short along the curve, but
//! where triangles are long, as when all lifted sites lie on one plane, they pass √n of them and more
//! (`cargo run --release --example regular_cost` measures).
//!
//! *Assumes* finite coordinates and weights. *Does not* run in parallel but for the sorting, insert
//! segments, or change weights afterwards.

mod cavity;
mod insert;
mod order;
mod result;
mod row;

pub use crate::predicates::Weighted;
pub use result::Regular;

use crate::delaunay::check_number;
use crate::{Error, Mesh, Point, Watch, parallel};

/// Makes the regular triangulation of points with weights, unwatched; see [`WeightedDelaunay`].
///
/// ```
/// use delone::regular;
/// let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
/// let square = corners.map(|p| (p, 0.0));
/// let with_center = |weight| square.into_iter().chain([((2.0, 2.0), weight)]);
///
/// let t = regular::triangulate(with_center(0.0))?;
/// assert_eq!((t.triangulation().num_triangles(), t.hidden().len()), (4, 0));
/// // Corners that are so much stronger leave nothing for the center: 2² + 2² < 9.
/// let t = regular::triangulate(with_center(-9.0))?;
/// assert_eq!((t.triangulation().num_triangles(), t.hidden()), (2, &[4.into()][..]));
/// # Ok::<(), delone::Error>(())
/// ```
///
/// # Errors
/// As [`WeightedDelaunay::triangulate`], but for the watch.
pub fn triangulate<P: Into<Point>>(
    sites: impl IntoIterator<Item = (P, f64)>,
) -> Result<Regular, Error> {
    WeightedDelaunay::new().triangulate(sites)
}

/// How to make a regular triangulation: who watches.
#[derive(Clone, Copy)]
pub struct WeightedDelaunay<'w> {
    watch: &'w dyn Watch,
}

impl Default for WeightedDelaunay<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'w> WeightedDelaunay<'w> {
    /// Is unwatched.
    pub fn new() -> Self {
        Self { watch: &() }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch }
    }

    /// Triangulates points, each with its weight in units of squared length.
    ///
    /// # Errors
    /// [`Error::NotFinite`] names the first point with a coordinate that is NaN or infinite, and
    /// [`Error::BadWeight`] the first such weight; [`Error::TooManyPoints`] if ids would not fit 32 bits;
    /// [`Error::Cancelled`] if the watch says so.
    ///
    /// *Cost*: see the [module](self).
    pub fn triangulate<P: Into<Point>>(
        self,
        sites: impl IntoIterator<Item = (P, f64)>,
    ) -> Result<Regular, Error> {
        let sites = sites.into_iter().map(|(p, weight)| (p.into(), weight));
        let (points, weights): (Vec<Point>, Vec<f64>) = sites.unzip();
        check_number(points.len())?;
        if let Some(index) = weights.iter().position(|w| !w.is_finite()) {
            let weight = weights[index];
            return Err(Error::BadWeight { index, weight });
        }
        parallel::with_workers(None, |workers| {
            let Some(sites) = order::distinct(&points, &weights, workers, self.watch)? else {
                return Ok(Regular::new(points, weights, Mesh::default(), 0, None));
            };
            let only = (sites.names.len() == 1).then(|| sites.names[0]);
            let (mesh, num_triangles) = insert::build(sites, self.watch)?;
            Ok(Regular::new(points, weights, mesh, num_triangles, only))
        })?
    }
}
