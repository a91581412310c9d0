//! Writing: version 1, C order, little-endian.

use super::MAGIC;
use crate::target::Output;
use crate::{Error, Links, MeshView};
use delone::surface::Raster;

/// Writes the triangles as `int32` (m, 3), or `int64` if there are too many vertices.
pub(crate) fn write_triangles(out: &mut Output<'_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let rows = mesh.triangles.iter().map(|t| t.map(|v| v.raw().into()));
    write_integers(out, mesh, mesh.triangles.len(), rows)
}

/// Writes the constrained edges as `int32` (k, 3): their ends and their markers; `int64` if there are
/// too many vertices.
pub(crate) fn write_segments(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
) -> Result<(), Error> {
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    let rows = edges.iter().zip(markers);
    write_integers(
        out,
        mesh,
        edges.len(),
        rows.map(|([a, b], &marker)| [a.raw().into(), b.raw().into(), marker.into()]),
    )
}

/// Writes rows of three integers, with as many bytes as the ids of vertices need.
fn write_integers(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    num_rows: usize,
    rows: impl Iterator<Item = [i64; 3]>,
) -> Result<(), Error> {
    let small = mesh.points.len() <= i32::MAX as usize;
    let (descr, width) = if small { ("<i4", 4) } else { ("<i8", 8) };
    write_header(out, descr, num_rows, 3)?;
    for row in rows {
        for value in row {
            out.bytes(&value.to_le_bytes()[..width])?;
        }
        out.end_row()?;
    }
    Ok(())
}

/// Writes the points as `float64` (n, 2 + attributes), and markers as a last column.
pub(crate) fn write_points(out: &mut Output<'_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let attributes = mesh.attributes;
    let columns = 2 + attributes.len() + usize::from(mesh.markers.is_some());
    write_header(out, "<f8", mesh.points.len(), columns)?;
    for (i, p) in mesh.points.iter().enumerate() {
        out.bytes(&p.x.to_le_bytes())?;
        out.bytes(&p.y.to_le_bytes())?;
        for attribute in attributes {
            out.bytes(&attribute.values[i].to_le_bytes())?;
        }
        if let Some(markers) = mesh.markers {
            out.bytes(&f64::from(markers[i]).to_le_bytes())?;
        }
        out.end_row()?;
    }
    Ok(())
}

/// Writes a raster as `float64` (rows, columns), the top row first, NaN where there is no value.
pub(crate) fn write_raster(out: &mut Output<'_>, raster: &Raster) -> Result<(), Error> {
    let grid = raster.grid();
    write_header(out, "<f8", grid.rows(), grid.columns())?;
    for row in raster.rows() {
        for value in row {
            out.bytes(&value.to_le_bytes())?;
        }
        out.end_row()?;
    }
    Ok(())
}

/// Writes links as `float64` (m, 3): the numbers of their ends, and their lengths.
pub(crate) fn write_links(out: &mut Output<'_>, links: &Links<'_>) -> Result<(), Error> {
    write_header(out, "<f8", links.links.len(), 3)?;
    for link in links.links {
        let [from, to] = links.numbers(link).map(|number| number as f64);
        for value in [from, to, link.length] {
            out.bytes(&value.to_le_bytes())?;
        }
        out.end_row()?;
    }
    Ok(())
}

fn write_header(
    out: &mut Output<'_>,
    descr: &str,
    rows: usize,
    columns: usize,
) -> Result<(), Error> {
    let dictionary =
        format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    // Blanks and a newline fill up to a multiple of 64, so that the data may be mapped.
    let length = (MAGIC.len() + 4 + dictionary.len() + 1).next_multiple_of(64) - MAGIC.len() - 4;
    out.bytes(MAGIC)?;
    out.bytes(&[1, 0])?;
    out.bytes(&(length as u16).to_le_bytes())?;
    out.text(format_args!("{dictionary:<0$}\n", length - 1))
}
