//! Lloyd's relaxation: each site moves to the centroid of its cell, again and again.
//!
//! A step never raises the [energy](super::Clipped::energy), up to rounding: of all points the centroid
//! has the least sum of squared distances from its cell, and of all partitions the Voronoi diagram. So
//! the sites spread evenly, ever more slowly, until each is the centroid of its cell.

use super::{Clipped, Domain, Voronoi};
use crate::{Delaunay, Error, Phase, Point, Watch};

/// How to relax points.
///
/// ```
/// use delone::voronoi::{Domain, Lloyd};
///
/// let square = Domain::rectangle((0.0, 0.0), (1.0, 1.0))?;
/// let relaxed = Lloyd::new(50).relax([(0.1, 0.2), (0.3, 0.1)], &square)?;
/// // Two halves of the square, with their sites in the middle.
/// assert!(relaxed.energies.is_sorted_by(|a, b| b - a < 1e-15));
/// assert!((relaxed.energies.last().unwrap() - 5.0 / 48.0).abs() < 1e-9);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Lloyd<'w> {
    steps: usize,
    least_movement: f64,
    watch: &'w dyn Watch,
}

/// Points that have been relaxed.
#[derive(Clone, Debug, PartialEq)]
pub struct Relaxed {
    /// Where they are now, in the order of the input.
    pub points: Vec<Point>,
    /// The energy at the beginning and after each step.
    pub energies: Vec<f64>,
    /// How far, at most, a point has moved in the last step; 0 if there was none.
    pub movement: f64,
}

impl<'w> Lloyd<'w> {
    /// Takes so many steps, fewer if nothing moves any more; unwatched.
    pub fn new(steps: usize) -> Self {
        Self {
            steps,
            least_movement: 0.0,
            watch: &(),
        }
    }

    /// Stops after the first step in which no point moves farther than this.
    pub fn until(self, movement: f64) -> Self {
        Self {
            least_movement: movement,
            ..self
        }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'w dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Relaxes points in a domain.
    ///
    /// A point whose cell does not meet the domain stays where it is. A centroid may lie outside of a
    /// domain that is not convex. Equal points move together. The result does not depend on the number of
    /// threads.
    ///
    /// # Errors
    /// Those of [`Delaunay::triangulate`].
    ///
    /// *Cost*: for each step a triangulation, a diagram and its clipping: about 2 µs a point.
    pub fn relax<P: Into<Point>>(
        self,
        points: impl IntoIterator<Item = P>,
        domain: &Domain,
    ) -> Result<Relaxed, Error> {
        let mut relaxed = Relaxed {
            points: points.into_iter().map(Into::into).collect(),
            energies: Vec::new(),
            movement: 0.0,
        };
        for step in 0..=self.steps {
            let total = self.steps as u64;
            self.watch.progress(Phase::Relax, step as u64, total);
            let points = relaxed.points.iter().copied();
            let t = Delaunay::new().watch(self.watch).triangulate(points)?;
            let voronoi = Voronoi::new(&t, self.watch)?;
            let clipped = voronoi.clip(domain, self.watch)?;
            relaxed.energies.push(clipped.energy());
            let is_last = step > 0 && relaxed.movement <= self.least_movement;
            if step == self.steps || is_last {
                break;
            }
            relaxed.movement = advance(&mut relaxed.points, &clipped);
        }
        Ok(relaxed)
    }
}

/// Moves all points to the centroids of their cells, and returns how far at most.
fn advance(points: &mut [Point], clipped: &Clipped<'_>) -> f64 {
    let mut most: f64 = 0.0;
    let centroids = clipped.of_sites(|site| clipped.measure(site).centroid);
    for (point, centroid) in points.iter_mut().zip(centroids) {
        if centroid.is_finite() {
            most = most.max(super::measure::distance(*point, centroid));
            *point = centroid;
        }
    }
    most
}
