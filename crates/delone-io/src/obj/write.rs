//! Writing: vertices, then what joins them; a group begins where region or marker change.

use super::{MARKER, POINTS, REGION, SEGMENTS, TRIANGLES};
use crate::target::Output;
use crate::{Error, MeshView, WriteOptions, space};
use delone::VertexId;

/// Writes a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    _options: &WriteOptions,
) -> Result<(), Error> {
    let heights = space::heights(mesh);
    for (v, p) in mesh.points.iter().enumerate() {
        out.bytes(b"v")?;
        for value in [p.x, p.y, heights.map_or(0.0, |z| z[v])] {
            out.blank();
            out.number(value);
        }
        out.end_line()?;
    }
    write_triangles(out, mesh)?;
    write_edges(out, mesh, markers)?;
    write_loose_points(out, mesh)
}

fn write_triangles(out: &mut Output<'_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let region_of = space::regions(mesh);
    let mut current = None;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let region = region_of.as_ref().and_then(|of| of[t]);
        if current.replace(region) != Some(region) {
            match region {
                Some(region) => out.text(format_args!("g {REGION}{region}\n"))?,
                None => out.text(format_args!("g {TRIANGLES}\n"))?,
            }
        }
        element(out, b"f", corners)?;
    }
    Ok(())
}

fn write_edges(out: &mut Output<'_>, mesh: &MeshView<'_>, markers: &[i32]) -> Result<(), Error> {
    let Some(constraints) = mesh.constraints else {
        return Ok(());
    };
    let has_markers = constraints.markers.is_some() || !mesh.triangles.is_empty();
    let mut current = None;
    for (edge, &marker) in constraints.edges.iter().zip(markers) {
        if current.replace(marker) != Some(marker) {
            match has_markers {
                true => out.text(format_args!("g {MARKER}{marker}\n"))?,
                false => out.text(format_args!("g {SEGMENTS}\n"))?,
            }
        }
        element(out, b"l", edge)?;
    }
    Ok(())
}

/// Writes the points that nothing else names, which programs for modelling would not show.
fn write_loose_points(out: &mut Output<'_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let mut is_loose = vec![true; mesh.points.len()];
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    for v in mesh
        .triangles
        .as_flattened()
        .iter()
        .chain(edges.as_flattened())
    {
        is_loose[v.index()] = false;
    }
    if is_loose.contains(&true) {
        out.text(format_args!("g {POINTS}\n"))?;
    }
    let all = is_loose.into_iter().enumerate();
    for (v, _) in all.filter(|(_, is_loose)| *is_loose) {
        element(out, b"p", &[VertexId::new(v)])?;
    }
    Ok(())
}

/// Writes a statement about vertices, numbered from 1.
fn element(out: &mut Output<'_>, keyword: &[u8], vertices: &[VertexId]) -> Result<(), Error> {
    out.bytes(keyword)?;
    for v in vertices {
        out.blank();
        out.integer(i64::from(v.raw()) + 1);
    }
    out.end_line()
}
