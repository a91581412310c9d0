//! What outputs hold, and which formats can.

use crate::exit::Failure;
use delone_io::Format;
use std::path::Path;

/// What an output must be able to hold.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Content {
    /// Points alone.
    Points,
    /// Points and segments, holes and regions.
    Domain,
    /// Points and triangles.
    Mesh,
    /// Points and triangles of six nodes.
    QuadraticMesh,
    /// Points, a domain or a mesh, as the input will tell.
    Any,
    /// A picture.
    Picture,
    /// A page about a mesh.
    Report,
    /// Pairs of points.
    Links,
    /// Voronoi cells.
    Cells,
    /// Triangle's `.v.node` and `.v.edge`, of which either is named.
    Diagram,
    /// Points, besides something else.
    Sites,
    /// Values in the cells of a grid.
    Raster,
    /// Contour lines.
    Contours,
    /// A picture of a surface, besides something else.
    Relief,
    /// Troubles of a drawing, on its picture or as features, besides something else.
    Troubles,
}

impl Content {
    pub(super) fn fits(self, format: Format) -> bool {
        match self {
            Self::Points => format.writes_points(),
            Self::Domain => format.writes_segments(),
            Self::Mesh => format.writes_mesh(),
            Self::QuadraticMesh => format.writes_quadratic_mesh(),
            Self::Any => format.writes_points() || format.writes_segments() || format.writes_mesh(),
            Self::Picture => format.is_picture(),
            Self::Report => format.writes_report(),
            Self::Links => format.writes_links(),
            Self::Cells => format.writes_cells(),
            Self::Diagram => matches!(format, Format::Node | Format::Edge),
            Self::Sites => format.writes_points(),
            Self::Raster => format.writes_raster(),
            Self::Contours => format.writes_contours(),
            Self::Relief => format.is_picture(),
            Self::Troubles => format.is_picture() || format == Format::GeoJson,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Domain => "a domain",
            Self::Mesh => "a mesh",
            Self::QuadraticMesh => "triangles of six nodes",
            Self::Any => "points or a mesh",
            Self::Picture => "a picture",
            Self::Report => "a report",
            Self::Links => "links between points",
            Self::Cells => "cells",
            Self::Diagram => "a diagram",
            Self::Sites => "points",
            Self::Raster => "a raster",
            Self::Contours => "contour lines",
            Self::Relief => "a picture",
            Self::Troubles => "troubles",
        }
    }

    /// Tells whether it is not what a command is about, but something besides.
    pub(super) fn is_aside(self) -> bool {
        matches!(
            self,
            Self::Report | Self::Diagram | Self::Sites | Self::Relief | Self::Troubles
        )
    }

    /// Says that standard output will not do.
    pub(super) fn needs_a_file(self) -> Failure {
        let formats = Format::ALL.into_iter().filter(|&f| self.fits(f));
        let names: Vec<String> = formats.map(|f| format!(".{}", f.name())).collect();
        let what = self.name();
        let one = if what.ends_with('s') { "need" } else { "needs" };
        Failure::Usage(format!(
            "{what} {one} a file; name one with one of these extensions: {}",
            names.join(", ")
        ))
    }

    /// Says why an output of the format that was `told` will not do.
    pub(super) fn misfit(self, path: &Path, told: Option<Format>) -> Failure {
        let [path, what] = [path.display().to_string(), self.name().to_owned()];
        let names = Format::ALL.map(|f| self.fits(f).then_some(f.name()));
        let names: Vec<&str> = names.into_iter().flatten().collect();
        let names = names.join(", ");
        Failure::Usage(match told {
            Some(format) => format!("{path}: {format} cannot hold {what}; these can: {names}"),
            None => format!(
                "{path}: the name tells no format; add an extension or --to with one of: {names}"
            ),
        })
    }
}
