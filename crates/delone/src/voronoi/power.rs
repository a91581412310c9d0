//! The power diagram: the same cells, of sites with weights.
//!
//! Its dual is the regular triangulation. Sides stay perpendicular to the way from site to site, but
//! weights move them, so a site may lie outside its cell, and a hidden one has none. A site that is no
//! more than tied has a cell without area: a point, which has no sides, or a line.

use super::Voronoi;
use super::diagram::Power;
use super::dual::dual;
use crate::regular::Regular;
use crate::{Error, Watch};

impl Voronoi {
    /// Makes the power diagram of a regular triangulation: each place belongs to the site of least power,
    /// which is the square of its distance less its weight.
    ///
    /// [`cells`](Self::cells) leaves hidden sites out. The diagram is as exact as that without weights:
    /// vertices are [power centers](crate::predicates::power_center), one for all triangles that only the
    /// perturbation tells apart, and clipping decides by the exact power.
    ///
    /// ```
    /// use delone::{regular, voronoi::{Domain, Voronoi}};
    ///
    /// let t = regular::triangulate([((0.0, 0.0), 4.0), ((4.0, 0.0), 0.0)])?;
    /// let power = Voronoi::weighted(&t, &())?;
    /// // The border has moved from 2 to 2 + 4 / (2 · 4) = 2.5.
    /// let clipped = power.clip(&Domain::rectangle((0.0, 0.0), (4.0, 1.0))?, &())?;
    /// assert_eq!([0, 1].map(|v| clipped.measure(v.into()).area), [2.5, 1.5]);
    /// # Ok::<(), delone::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so.
    ///
    /// *Cost*: linear; about 0.5 µs a site.
    pub fn weighted(regular: &Regular, watch: &dyn Watch) -> Result<Self, Error> {
        let t = regular.triangulation();
        let sites = Power {
            points: t.points(),
            weights: regular.weights(),
        };
        let diagram = dual(t.mesh(), t.points().len(), &sites, watch)?;
        Ok(Self {
            sites: t.points().to_vec(),
            diagram: diagram.expect("bug: not regular"),
            duplicates: Vec::new(),
            weights: Some(regular.weights().to_vec()),
            hidden: regular.hidden().to_vec(),
        })
    }
}
