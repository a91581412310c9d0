//! Surfaces in files: rasters, contour lines, and pictures of both.

use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Error, Format, PictureOptions, Target, asc, geojson, npy, picture};
use delone::Watch;
use delone::surface::{Contour, Raster};
use std::path::PathBuf;

/// What is to be written of a surface.
#[derive(Clone, Copy, Debug, Default)]
pub struct Relief<'a> {
    /// Values in cells.
    pub raster: Option<&'a Raster>,
    /// Contour lines.
    pub contours: &'a [Contour],
}

/// How reliefs are written.
#[derive(Clone, Debug, PartialEq)]
pub struct ReliefOptions {
    /// Size and legend of pictures.
    pub picture: PictureOptions,
    /// Shades the slopes of a raster in pictures, as if lit from the upper left.
    pub shade: bool,
    /// Writes the level on lines that are long enough, in pictures.
    pub labels: bool,
}

impl Default for ReliefOptions {
    fn default() -> Self {
        Self {
            picture: PictureOptions::default(),
            shade: true,
            labels: true,
        }
    }
}

/// Writes a raster or contour lines to every target and returns the names of the files written.
///
/// - `.asc` (ESRI's ASCII grid; standard output as [`Format::Table`]) and `.npy` (`float64`, rows by columns)
///   hold the raster, top row first; cells without value are `NODATA_value` and NaN;
/// - `.geojson` holds the lines, with the property `level`, the higher side to the left;
/// - `.png` and `.svg` show what there is: cells in colours from dark (low) to light (high), lines upon
///   them, every fifth level thicker.
///
/// ```
/// use delone::surface::{Evaluation, Grid, Linear, Samples, contours};
/// use delone_io::{Relief, ReliefOptions, Target};
///
/// # let folder = tempfile::tempdir()?;
/// # let place = |name: &str| folder.path().join(name);
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])?;
/// let samples = Samples::new(&t, [10.0, 20.0, 35.0])?;
/// let grid = Grid::with_cells((0.0, 0.0).into(), (4.0, 4.0).into(), 0.5)?;
/// let raster = Evaluation::new().raster(&Linear::new(&samples), grid)?;
/// let lines = contours(&samples, &[15.0, 20.0, 25.0], &())?;
/// let relief = Relief { raster: Some(&raster), contours: &lines };
/// let targets = ["hill.asc", "hill.geojson", "hill.png"].map(|name| Target::from_arg(place(name), None));
/// let written = delone_io::write_relief(&targets, relief, &ReliefOptions::default(), &())?;
/// assert_eq!(written.len(), 3);
/// assert!(std::fs::read_to_string(place("hill.asc"))?.starts_with("ncols 8\nnrows 8\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a format can hold nothing of what there is, writing fails, or the watch cancels.
pub fn write_relief(
    targets: &[Target],
    relief: Relief<'_>,
    options: &ReliefOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let rows = relief.raster.map_or(0, |raster| raster.grid().rows());
    let total = (rows + relief.contours.len()) * targets.len();
    let mut staging = Staging::new(total as u64, watch);
    for target in targets {
        staging.write(target.path.as_deref(), |out| {
            write(out, target, relief, options, watch)
        })?;
    }
    staging.commit()
}

/// Writes one file.
fn write(
    out: &mut Output<'_>,
    target: &Target,
    relief: Relief<'_>,
    options: &ReliefOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let format = target.format()?;
    match (format, relief.raster) {
        (Format::Table, Some(raster)) if is_grid(target) => asc::write(out, raster),
        (Format::Npy, Some(raster)) => npy::write_raster(out, raster),
        (Format::GeoJson, _) => geojson::write_contours(out, relief.contours),
        (Format::Png, _) => picture::relief::write_png(out, relief, options, watch),
        (Format::Svg, _) => picture::relief::write_svg(out, relief, options, watch),
        (_, Some(_)) => Err(unsupported(target, format, "hold a raster", |f| {
            matches!(f, Format::Npy | Format::Svg | Format::Png)
        })),
        (_, None) => Err(unsupported(
            target,
            format,
            "hold contour lines",
            Format::writes_contours,
        )),
    }
}

/// Tells whether a table is to be an ASCII grid: tables of other names are something else.
fn is_grid(target: &Target) -> bool {
    let extension = target.path.as_ref().map(|path| path.extension());
    extension.is_none_or(|e| e.is_some_and(|e| e.eq_ignore_ascii_case("asc")))
}
