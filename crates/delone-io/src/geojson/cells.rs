//! Writing Voronoi cells: a feature each.

use super::write::List;
use crate::target::Output;
use crate::{CellsView, Error};
use delone::voronoi::Part;
use delone::{Point, VertexId};

/// Writes each cell as a polygon, or as several, with what is known of it as properties.
pub(crate) fn write_cells(
    out: &mut Output<'_>,
    cells: &CellsView<'_>,
    base: usize,
) -> Result<(), Error> {
    let mut list = List::begin(out)?;
    for site in cells.sites() {
        list.next(|out| {
            write_properties(out, cells, site, base)?;
            let parts = cells.clipped.parts(site);
            let (kind, is_single) = match parts.len() {
                1 => ("Polygon", true),
                _ => ("MultiPolygon", false),
            };
            let open = if is_single { "" } else { "[" };
            out.text(format_args!(
                ",\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":{open}"
            ))?;
            for (i, part) in parts.enumerate() {
                out.bytes(if i == 0 { b"" } else { b"," })?;
                write_part(out, &part)?;
            }
            out.bytes(if is_single { b"}" } else { b"]}" })
        })?;
    }
    list.end()
}

fn write_properties(
    out: &mut Output<'_>,
    cells: &CellsView<'_>,
    site: VertexId,
    base: usize,
) -> Result<(), Error> {
    out.text(format_args!("{{\"site\":{},\"area\":", site.index() + base))?;
    write_number(out, cells.clipped.measure(site).area)?;
    for attribute in cells.attributes {
        let name = serde_json::Value::from(attribute.name.as_str());
        out.text(format_args!(",{name}:"))?;
        write_number(out, attribute.values[site.index()])?;
    }
    if let Some(markers) = cells.markers {
        out.text(format_args!(",\"marker\":{}", markers[site.index()]))?;
    }
    out.bytes(b"}")
}

fn write_number(out: &mut Output<'_>, number: f64) -> Result<(), Error> {
    if !number.is_finite() {
        return out.bytes(b"null");
    }
    out.number(number);
    Ok(())
}

/// Writes an outline and its holes, each back at its first point.
fn write_part(out: &mut Output<'_>, part: &Part<'_>) -> Result<(), Error> {
    for (i, ring) in part.rings().enumerate() {
        out.bytes(if i == 0 { b"[[" } else { b",[" })?;
        for (k, p) in ring.iter().chain(ring.first()).enumerate() {
            out.bytes(if k == 0 { b"" } else { b"," })?;
            write_position(out, *p)?;
        }
        out.bytes(b"]")?;
    }
    out.bytes(b"]")
}

fn write_position(out: &mut Output<'_>, p: Point) -> Result<(), Error> {
    out.bytes(b"[")?;
    out.number(p.x);
    out.separator(b',');
    out.number(p.y);
    out.bytes(b"]")
}
