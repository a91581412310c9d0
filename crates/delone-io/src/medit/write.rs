//! Writing: version 2, which is of doubles.

use crate::points::unsupported;
use crate::target::Output;
use crate::{Error, Format, MeshView, WriteOptions};
use delone::VertexId;

/// Writes a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    _options: &WriteOptions,
) -> Result<(), Error> {
    let named = mesh.constraints.filter(|_| mesh.triangles.is_empty());
    if named.is_some_and(|c| !c.holes.is_empty() || !c.regions.is_empty()) {
        let seeds = "hold holes and regions that are named by points";
        return Err(unsupported(out.file(), Format::Medit, seeds, |f| {
            f == Format::Poly
        }));
    }
    out.text(format_args!("MeshVersionFormatted 2\n\nDimension 2\n"))?;
    section(out, "Vertices", mesh.points.len())?;
    for (v, p) in mesh.points.iter().enumerate() {
        out.number(p.x);
        out.blank();
        out.number(p.y);
        out.blank();
        out.integer(mesh.markers.map_or(0, |markers| markers[v]).into());
        out.end_line()?;
    }
    write_edges(out, mesh, markers)?;
    write_triangles(out, mesh)?;
    out.text(format_args!("\nEnd\n"))
}

/// Begins a section, unless it would be empty.
fn section(out: &mut Output<'_>, name: &str, rows: usize) -> Result<(), Error> {
    match rows {
        0 if name != "Vertices" => Ok(()),
        _ => out.text(format_args!("\n{name}\n{rows}\n")),
    }
}

fn row(out: &mut Output<'_>, nodes: &[VertexId], reference: i64) -> Result<(), Error> {
    for v in nodes {
        out.integer(i64::from(v.raw()) + 1);
        out.blank();
    }
    out.integer(reference);
    out.end_line()
}

/// Writes constrained edges; those without triangle have no midpoint, and stand in a section of their own.
fn write_edges(out: &mut Output<'_>, mesh: &MeshView<'_>, markers: &[i32]) -> Result<(), Error> {
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    let middle = |e: usize| mesh.middles.and_then(|middles| middles.of_constrained[e]);
    let bent = (0..edges.len()).filter(|&e| middle(e).is_some()).count();
    section(out, "Edges", edges.len() - bent)?;
    for (e, ends) in edges.iter().enumerate() {
        if middle(e).is_none() {
            row(out, ends, markers[e].into())?;
        }
    }
    section(out, "EdgesP2", bent)?;
    for (e, &[a, b]) in edges.iter().enumerate() {
        if let Some(middle) = middle(e) {
            row(out, &[a, b, middle], markers[e].into())?;
        }
    }
    Ok(())
}

/// Writes triangles. Midpoints are those opposite the corners, but Medit begins with the one between the first two.
fn write_triangles(out: &mut Output<'_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let regions = mesh.constraints.and_then(|c| c.region_of.as_ref());
    let reference = |t: usize| regions.and_then(|of| of[t]).map_or(0, |r| i64::from(r) + 1);
    let name = match mesh.middles {
        Some(_) => "TrianglesP2",
        None => "Triangles",
    };
    section(out, name, mesh.triangles.len())?;
    for (t, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        match mesh.middles.map(|middles| middles.of_triangles[t]) {
            Some([bc, ca, ab]) => row(out, &[a, b, c, ab, bc, ca], reference(t))?,
            None => row(out, &[a, b, c], reference(t))?,
        }
    }
    Ok(())
}
