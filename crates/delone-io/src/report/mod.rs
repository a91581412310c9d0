//! Reports: what was asked of a refined mesh, what was reached, and what not, on one page.
//!
//! A page for the browser needs nothing beside it, no network and no script; a picture holds the same
//! without the unmet triangles. Both show the mesh as other pictures do.

mod chart;
mod clip;
mod figures;
mod html;
mod page;
mod unmet;
mod zoom;

use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Error, Format, MeshView, PictureOptions, Target};
use delone::{RefinedMesh, Watch};
use std::path::PathBuf;

/// What a report says beyond the mesh and its figures, and how its picture looks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReportOptions<'a> {
    /// What was meshed: the headline.
    pub name: &'a str,
    /// The number of the first point and the first segment in the file of the input.
    pub base: usize,
    /// How the mesh was made, for the page for the browser, as names and values: time, threads, hash …
    pub details: &'a [(&'a str, String)],
    /// How the picture of the mesh looks.
    pub picture: PictureOptions,
}

/// What a report is about.
struct Subject<'a> {
    refined: &'a RefinedMesh,
    mesh: &'a MeshView<'a>,
    watch: &'a dyn Watch,
}

/// Writes a report on a refined mesh and returns the names of the files written.
///
/// `mesh` is the [view](MeshView::constrained) of what `refined` holds. `.html` is a page that needs
/// nothing beside it: figures, picture, histograms, and the worst of the unmet triangles, enlarged, with
/// the reason of each. `.svg` and `.png` hold picture, histograms and figures.
///
/// # Errors
/// If `mesh` is not the mesh of `refined`, a target has another format, writing fails, or the watch
/// cancels.
pub fn write_report(
    targets: &[Target],
    refined: &RefinedMesh,
    mesh: &MeshView<'_>,
    options: &ReportOptions<'_>,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    mesh.validate()?;
    if mesh.triangles != refined.mesh.triangulation().triangles() {
        let reason = "the report is about other triangles than the mesh has";
        return Err(Error::BadMesh(reason.to_owned()));
    }
    let subject = Subject {
        refined,
        mesh,
        watch,
    };
    let mut staging = Staging::new(0, watch);
    for target in targets {
        let write = writer(target)?;
        staging.write(target.path.as_deref(), |out| write(out, &subject, options))?;
    }
    staging.commit()
}

/// Writes a report into a file.
type Writer = fn(&mut Output<'_>, &Subject<'_>, &ReportOptions<'_>) -> Result<(), Error>;

fn writer(target: &Target) -> Result<Writer, Error> {
    let format = target.format().map_err(|_| Error::UnknownFormat {
        file: target.to_string(),
        known: Format::names(Format::writes_report),
    })?;
    match format {
        Format::Html => Ok(html::write),
        Format::Svg => Ok(page::write_svg),
        Format::Png => Ok(page::write_png),
        format => {
            let action = "hold a report";
            Err(unsupported(target, format, action, Format::writes_report))
        }
    }
}
