//! Voronoi cells that are to be written.

use crate::{Attribute, Error, PointSet};
use delone::voronoi::{Clipped, Part};
use delone::{Point, VertexId};

/// Clipped cells and what goes with their sites.
///
/// ```
/// use delone::voronoi::{Domain, Voronoi};
/// use delone_io::{CellsView, Target, WriteOptions};
///
/// # let folder = tempfile::tempdir()?;
/// # let place = |name: &str| folder.path().join(name);
/// let t = delone::triangulate([(0.1, 0.2), (0.8, 0.4), (0.5, 0.9)])?;
/// let voronoi = Voronoi::new(&t, &())?;
/// let clipped = voronoi.clip(&Domain::rectangle((0.0, 0.0), (1.0, 1.0))?, &())?;
/// let targets = ["cells.geojson", "cells.svg"].map(|name| Target::from_arg(place(name), None));
/// let options = WriteOptions::default();
/// let written = delone_io::write_cells(&targets, &CellsView::new(&clipped), &options, &())?;
/// assert_eq!(written.len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CellsView<'a> {
    /// The cells.
    pub clipped: &'a Clipped<'a>,
    /// Numbers that go with the sites.
    pub attributes: &'a [Attribute],
    /// Markers of the sites.
    pub markers: Option<&'a [i32]>,
}

impl<'a> CellsView<'a> {
    /// Makes a view of cells.
    pub fn new(clipped: &'a Clipped<'a>) -> Self {
        Self {
            clipped,
            attributes: &[],
            markers: None,
        }
    }

    /// Adds attributes and markers, as they were read with the sites.
    pub fn with_data(self, data: &'a PointSet) -> Self {
        Self {
            attributes: &data.attributes,
            markers: data.markers.as_deref(),
            ..self
        }
    }

    /// Visits the distinct sites whose cells have parts.
    pub(crate) fn sites(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        let sites = self.clipped.voronoi().sites();
        let clipped = self.clipped;
        let all = (0..sites.len()).map(VertexId::new);
        let distinct = all.filter(|&v| clipped.voronoi().representative(v) == v);
        distinct.filter(|&v| clipped.parts(v).len() > 0)
    }

    /// Visits all parts, with their sites.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (VertexId, Part<'a>)> + Clone + '_ {
        let clipped = self.clipped;
        self.sites()
            .flat_map(move |v| clipped.parts(v).map(move |part| (v, part)))
    }

    pub(crate) fn site(&self, v: VertexId) -> Point {
        self.clipped.voronoi().sites()[v.index()]
    }

    /// Checks that every table has the right length.
    pub(crate) fn validate(&self) -> Result<(), Error> {
        let n = self.clipped.voronoi().sites().len();
        let lengths = self
            .attributes
            .iter()
            .map(|a| (&a.name[..], a.values.len()));
        let markers = self.markers.map(|markers| ("markers", markers.len()));
        match lengths.chain(markers).find(|&(_, found)| found != n) {
            Some((what, found)) => Err(Error::BadMesh(format!(
                "{what:?} has {found} values for {n} sites"
            ))),
            None => Ok(()),
        }
    }
}
