//! Cells clipped to a domain.

use super::Voronoi;
use super::diagram::{Euclidean, Metric};
use super::domain::Domain;
use super::measure::{Measure, Moments, Unit, second_moment};
use super::overlay::Overlay;
use super::parts::{Part, Shapes};
use super::trace::{Trace, Tracer};
use crate::pace::Pace;
use crate::parallel::{Workers, joined};
use crate::{Error, Phase, Point, VertexId, Watch};
use std::convert::Infallible;

impl Voronoi {
    /// Clips all cells to a domain.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so.
    ///
    /// *Cost*: about 0.3 µs a site, and 1 µs each time that the boundary crosses an edge; see the
    /// [module](super).
    pub fn clip(&self, domain: &Domain, watch: &dyn Watch) -> Result<Clipped<'_>, Error> {
        let work = self.sites.len() + self.diagram.edges.len() + domain.points().len();
        let mut pace = Pace::new(watch, Phase::Voronoi, work as u64);
        let trace = match self.power() {
            Some(metric) => self.trace(&metric, domain, &mut pace)?,
            None => self.trace(&Euclidean(&self.sites), domain, &mut pace)?,
        };
        let overlay = Overlay::new(&self.diagram, &self.sites, domain, trace, &mut pace)?;
        let (shapes, lengths) = overlay.cut(Workers::around(), &pace)?;
        pace.finish();
        Ok(Clipped {
            voronoi: self,
            shapes,
            lengths,
        })
    }

    /// Follows the boundaries of a domain through the cells.
    fn trace(
        &self,
        metric: &impl Metric,
        domain: &Domain,
        pace: &mut Pace,
    ) -> Result<Trace, Error> {
        // Of cells without sides there is no way on to others.
        let has_sides = self.cells().find(|cell| cell.sides().len() > 0);
        let Some(start) = has_sides.or_else(|| self.cells().next()) else {
            return Ok(Trace::default());
        };
        let tracer = Tracer::new(&self.diagram, &self.sites, metric);
        tracer.follow(domain.rings(), domain.points(), start.site(), pace)
    }
}

/// The cells of a diagram, each clipped to a domain: none, one or several polygons, with holes.
///
/// ```
/// use delone::{Pslg, voronoi::{Domain, Voronoi}};
///
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0)])?;
/// let voronoi = Voronoi::new(&t, &())?;
/// // A U around the left site: the cell of the right one has two parts.
/// let mut u = Pslg::from_points([
///     (-1.0, -2.0), (3.0, -2.0), (3.0, -1.0), (0.0, -1.0), (0.0, 1.0), (3.0, 1.0), (3.0, 2.0), (-1.0, 2.0),
/// ]);
/// u.add_ring(0..8);
/// let clipped = voronoi.clip(&Domain::polygon(u, &())?, &())?;
/// assert_eq!(clipped.parts(1.into()).len(), 2);
/// assert_eq!(clipped.measure(1.into()).area, 2.0);
/// assert!(clipped.neighbors(1.into()).eq([(0.into(), 2.0)])); // two times one unit of border
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Clipped<'v> {
    voronoi: &'v Voronoi,
    shapes: Shapes,
    /// How much of each edge lies in the domain.
    lengths: Vec<f64>,
}

impl Clipped<'_> {
    /// Returns the diagram.
    pub fn voronoi(&self) -> &Voronoi {
        self.voronoi
    }

    /// Visits the parts of a cell; none if it has no area in the domain. A duplicate has those of the site
    /// that stands for it.
    ///
    /// # Panics
    /// If there is no such site.
    pub fn parts(&self, site: VertexId) -> impl ExactSizeIterator<Item = Part<'_>> + Clone {
        let site = self.voronoi.representative(site);
        self.shapes.parts(site)
    }

    /// Measures a cell, all its parts together; the centroid is NaN if there are none.
    pub fn measure(&self, site: VertexId) -> Measure {
        let parts = self.parts(site);
        Moments::of(parts.flat_map(|part| part.rings())).finish()
    }

    /// Finds something of every site, duplicates included.
    pub(super) fn of_sites<T: Copy + Send>(&self, find: impl Fn(VertexId) -> T + Sync) -> Vec<T> {
        let order = &self.voronoi.diagram.order;
        let lists = Workers::around().ranges(order.len(), |ranks| {
            let found = order[ranks].iter().map(|&site| find(site));
            Ok::<_, Infallible>(found.collect())
        });
        let Ok(lists) = lists;
        let found = joined(lists);
        let ranks = &self.shapes.ranks;
        ranks.iter().map(|&rank| found[rank as usize]).collect()
    }

    /// Visits the cells with which a cell shares border within the domain, counter-clockwise, with the
    /// length of that border, rounded.
    pub fn neighbors(&self, site: VertexId) -> impl Iterator<Item = (VertexId, f64)> + '_ {
        let is_empty = |site: VertexId| self.parts(site).len() == 0;
        let sides = (!is_empty(site)).then(|| self.voronoi.cell(site).sides());
        let lengths = sides.into_iter().flatten();
        let lengths = lengths.map(|side| (side.neighbor, self.lengths[side.edge]));
        lengths.filter(move |&(neighbor, length)| length > 0.0 && !is_empty(neighbor))
    }

    /// Integrates over the domain the squared distance to the nearest site: what
    /// [relaxation](super::Lloyd) lowers. In units of the coordinates to the fourth power, rounded.
    pub fn energy(&self) -> f64 {
        let sites = || self.voronoi.cells().map(|cell| cell.site());
        let rings = || sites().flat_map(|v| self.parts(v).flat_map(|part| part.rings()));
        let points = rings().flatten().chain(&self.voronoi.sites);
        let unit = Unit::of_points(points);
        let of_site = |site: VertexId| {
            let at: Point = self.voronoi.sites[site.index()];
            let rings = self.parts(site).flat_map(|part| part.rings());
            rings.map(|ring| second_moment(unit, at, ring)).sum::<f64>()
        };
        // Added up in order, whoever has found them.
        let energies = self.of_sites(of_site);
        let energy = sites().fold(0.0, |sum, v| sum + energies[v.index()]);
        unit.length(unit.length(unit.length(unit.length(energy))))
    }
}
