//! Links between points in files: who is near whom, graphs, tours.

use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Constraints, Error, Format, MeshView, PictureOptions, Target};
use crate::{cancel, geojson, npy, png, svg, table};
use delone::{Point, VertexId, Watch};
use std::path::PathBuf;

/// A link, as indices of its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The point where it begins, an index of [`Links::from`].
    pub from: usize,
    /// The point where it ends, an index of [`Links::to`].
    pub to: usize,
    /// Its length, in units of the coordinates.
    pub length: f64,
}

/// Links that are to be written.
#[derive(Clone, Copy, Debug)]
pub struct Links<'a> {
    /// The points where links begin.
    pub from: &'a [Point],
    /// The points where they end; `None` if these are the same.
    pub to: Option<&'a [Point]>,
    /// The links, in the order in which they are written.
    pub links: &'a [Link],
    /// What beginning, end and length are called.
    pub names: [&'a str; 3],
    /// The numbers of the first points on either side.
    pub bases: [usize; 2],
}

impl<'a> Links<'a> {
    /// Returns the points where links end.
    pub(crate) fn ends(&self) -> &'a [Point] {
        self.to.unwrap_or(self.from)
    }

    /// Returns the numbers by which files name the ends of a link.
    pub(crate) fn numbers(&self, link: &Link) -> [usize; 2] {
        [link.from + self.bases[0], link.to + self.bases[1]]
    }

    fn validate(&self) -> Result<(), Error> {
        let limits = [self.from.len(), self.ends().len()];
        for (i, link) in self.links.iter().enumerate() {
            let ends = [link.from, link.to];
            if let Some(side) = [0, 1].into_iter().find(|&side| ends[side] >= limits[side]) {
                let [end, limit] = [ends[side], limits[side]];
                return Err(Error::BadMesh(format!(
                    "link {i} names point {end} of {limit} (numbered from 0)"
                )));
            }
        }
        Ok(())
    }
}

/// Writes links to every target and returns the names of the files written.
///
/// - tables have a row for each link: the numbers of its ends, and its length; `.npy` is the same as
///   `float64` (links, 3);
/// - `.geojson` has a line for each, with the same as properties;
/// - `.png` and `.svg` show points as dots and links as lines; where links begin at other points than those
///   where they end, rings are around the former, if there is room.
///
/// ```
/// use delone_io::{Link, Links, PictureOptions, Target};
///
/// # let folder = tempfile::tempdir()?;
/// # let place = |name: &str| folder.path().join(name);
/// let points = [(0.0, 0.0), (3.0, 4.0)].map(Into::into);
/// let links = Links {
///     from: &points,
///     to: None,
///     links: &[Link { from: 0, to: 1, length: 5.0 }],
///     names: ["from", "to", "length"],
///     bases: [1, 1],
/// };
/// let targets = ["pair.csv", "pair.png"].map(|name| Target::from_arg(place(name), None));
/// let written = delone_io::write_links(&targets, &links, &PictureOptions::default(), &())?;
/// assert_eq!(written.len(), 2);
/// assert_eq!(std::fs::read_to_string(place("pair.csv"))?, "from,to,length\n1,2,5\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a link names no point, a format cannot hold links, writing fails, or the watch cancels.
pub fn write_links(
    targets: &[Target],
    links: &Links<'_>,
    options: &PictureOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    links.validate()?;
    let mut staging = Staging::new((links.links.len() * targets.len()) as u64, watch);
    for target in targets {
        let format = target.format()?;
        staging.write(target.path.as_deref(), |out| match format {
            Format::Table => table::write_links(out, target.path.as_deref(), links),
            Format::Npy => npy::write_links(out, links),
            Format::GeoJson => geojson::write_links(out, links),
            Format::Svg | Format::Png => draw(out, format, links, options, watch),
            format => Err(unsupported(
                target,
                format,
                "hold links",
                Format::writes_links,
            )),
        })?;
    }
    staging.commit()
}

/// Draws points and links, as the segments of a domain are drawn.
fn draw(
    out: &mut Output<'_>,
    format: Format,
    links: &Links<'_>,
    options: &PictureOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let ends = links.ends();
    let others = links.to.map_or(&[][..], |_| links.from);
    let shift = links.to.map_or(0, <[Point]>::len);
    let points = [ends, others].concat();
    let mut edges = Vec::with_capacity(links.links.len());
    for (i, link) in links.links.iter().enumerate() {
        cancel::check(watch, i)?;
        edges.push([shift + link.from, link.to].map(VertexId::new));
    }
    let constraints = Constraints {
        edges,
        crossings: ends.len()..points.len(),
        ..Constraints::default()
    };
    let mesh = MeshView::new(&points, &[]).with_constraints(&constraints);
    match format {
        Format::Svg => svg::write(out, &mesh, options, watch),
        _ => png::write(out, &mesh, options, watch),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_without_points_are_refused() {
        let points = [Point::new(0.0, 0.0), Point::new(1.0, 0.0)];
        let link = Link {
            from: 1,
            to: 1,
            length: 1.0,
        };
        let links = Links {
            from: &points,
            to: Some(&points[..1]),
            links: &[link],
            names: ["a", "b", "c"],
            bases: [0, 0],
        };
        let error = links.validate().expect_err("no such end").to_string();
        assert!(error.contains("link 0 names point 1 of 1"), "{error}");
    }
}
