//! Voronoi cells.

use super::WriteOptions;
use crate::picture::cells::CellScene;
use crate::points::unsupported;
use crate::target::Staging;
use crate::{CellsView, Error, Format, Target};
use crate::{geojson, png, svg, vtu};
use delone::Watch;
use std::path::PathBuf;

/// Writes Voronoi cells to every target and returns the names of the files written.
///
/// - `.geojson` holds for each cell a polygon, or several, with the number of its `site`, from 0 or 1,
///   its `area`, attributes and marker. Cells without area in the domain are left out.
/// - `.vtu` holds for each part of a cell a polygon, or triangles if it has holes, with the same as cell
///   data.
/// - Pictures show cells coloured by area, and sites.
///
/// # Errors
/// As [`write_mesh`](crate::write_mesh).
pub fn write_cells(
    targets: &[Target],
    cells: &CellsView<'_>,
    options: &WriteOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    cells.validate()?;
    let rows = (cells.sites().count() * targets.len()) as u64;
    let mut staging = Staging::new(rows, watch);
    let base = usize::from(options.one_based);
    for target in targets {
        let format = target.format()?;
        staging.write(target.path.as_deref(), |out| match format {
            Format::GeoJson => geojson::write_cells(out, cells, base),
            Format::Vtu => vtu::write_cells(out, cells, base, watch),
            Format::Svg => {
                let scene = CellScene::new(out.file(), cells, &options.picture, watch)?;
                svg::write_cells(out, &scene)
            }
            Format::Png => {
                let scene = CellScene::new(out.file(), cells, &options.picture, watch)?;
                png::write_cells(out, &scene)
            }
            format => Err(unsupported(
                target,
                format,
                "hold cells",
                Format::writes_cells,
            )),
        })?;
    }
    staging.commit()
}
