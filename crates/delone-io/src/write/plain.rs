//! Points and domains: what has no triangles yet.

use super::{WriteOptions, single};
use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{Constraints, DomainData, Error, Format, MeshView, PointSet, Target};
use crate::{geojson, node, npy, png, poly, svg, table, vtu};
use delone::Watch;
use std::path::PathBuf;

/// Writes points to every target and returns the names of the files written.
///
/// `.node`, `.poly`, tables and VTU carry attributes and markers; so does `.npy`, a `float64` array
/// (n, 2 + attributes) with the markers, if any, as a last column. GeoJSON carries `z`; pictures show bare points.
///
/// # Errors
/// As [`write_mesh`](crate::write_mesh).
pub fn write_points(
    targets: &[Target],
    points: &PointSet,
    options: &WriteOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    MeshView::new(&points.points, &[])
        .with_data(points)
        .validate()?;
    let rows = points.points.len() as u64 * targets.len() as u64;
    let mut staging = Staging::new(rows, watch);
    for target in targets {
        staging.write(target.path.as_deref(), |out| {
            write_bare(out, target, points, options, watch)
        })?;
    }
    staging.commit()
}

/// Writes points to one target.
fn write_bare(
    out: &mut Output<'_>,
    target: &Target,
    points: &PointSet,
    options: &WriteOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let mesh = MeshView::new(&points.points, &[]).with_data(points);
    let base = usize::from(options.one_based);
    match target.format()? {
        Format::Node => node::write(out, &mesh, mesh.markers, base),
        Format::Poly => {
            node::write(out, &mesh, mesh.markers, base)?;
            poly::write_graph(out, &mesh, None, base)
        }
        Format::GeoJson => geojson::write_points(out, points),
        Format::Npy => npy::write_points(out, &mesh),
        Format::Table => table::write_points(out, target.path.as_deref(), points),
        Format::Vtu => vtu::write(out, &mesh, &[]),
        Format::Svg => svg::write(out, &mesh, &options.picture, watch),
        Format::Png => png::write(out, &mesh, &options.picture, watch),
        #[cfg(feature = "parquet")]
        Format::Parquet => crate::parquet::write_points(out, &mesh),
        format if format.writes_points() => single::write(out, format, &mesh, &[], options),
        format => Err(unsupported(
            target,
            format,
            "hold bare points",
            Format::writes_points,
        )),
    }
}

/// Writes a domain to every target and returns the names of the files written.
///
/// `.poly` holds everything but which segments make a polygon; GeoJSON everything but the markers and
/// attributes of points (`z` excepted), and refuses holes and regions; pictures show the segments. A domain without segments, holes and regions goes into every
/// format that [`write_points`] writes.
///
/// # Errors
/// If a segment names no point, a format cannot hold segments, writing fails, or the watch cancels.
pub fn write_domain(
    targets: &[Target],
    domain: &DomainData,
    options: &WriteOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let constraints = Constraints {
        edges: domain.segments.clone(),
        markers: domain.segment_markers.clone(),
        holes: domain.holes.clone(),
        regions: domain.regions.clone(),
        ..Constraints::default()
    };
    let mesh = MeshView::new(&domain.vertices.points, &[])
        .with_data(&domain.vertices)
        .with_constraints(&constraints);
    mesh.validate()?;
    let rows = domain.vertices.points.len() + domain.segments.len();
    let mut staging = Staging::new((rows * targets.len()) as u64, watch);
    let base = usize::from(options.one_based);
    for target in targets {
        let format = target.format()?;
        staging.write(target.path.as_deref(), |out| match format {
            Format::Poly => {
                node::write(out, &mesh, mesh.markers, base)?;
                poly::write_graph(out, &mesh, constraints.markers.as_deref(), base)
            }
            Format::GeoJson if !constraints.has_seeds() => geojson::write_domain(out, domain),
            Format::GeoJson | Format::Msh | Format::Msh2 | Format::Vtk | Format::Vtu
                if constraints.has_seeds() =>
            {
                let seeds = "hold holes and regions that are named by points";
                Err(unsupported(target, format, seeds, |f| f == Format::Poly))
            }
            Format::Svg => svg::write(out, &mesh, &options.picture, watch),
            Format::Png => png::write(out, &mesh, &options.picture, watch),
            _ if constraints.is_empty() => {
                write_bare(out, target, &domain.vertices, options, watch)
            }
            format if format.writes_segments() => {
                let none = vec![0; constraints.edges.len()];
                let markers = constraints.markers.as_deref().unwrap_or(&none);
                single::write(out, format, &mesh, markers, options)
            }
            _ => Err(unsupported(
                target,
                format,
                "hold segments",
                Format::writes_segments,
            )),
        })?;
    }
    staging.commit()
}
