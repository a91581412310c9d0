//! Writing: one element for each array, numbers in base64 behind their count of bytes.

use super::{LINE, QUADRATIC_LINE, QUADRATIC_TRIANGLE, TRIANGLE};
use crate::target::Output;
use crate::{Attribute, Error, MeshView};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::VertexId;

/// Bytes encoded at once; divisible by 3, so that pieces join without padding.
const PIECE: usize = 3 << 13;

/// Writes points, triangles, constrained edges and attributes.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    edge_markers: &[i32],
) -> Result<(), Error> {
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    let (n, cells) = (mesh.points.len(), mesh.triangles.len() + edges.len());
    out.text(format_args!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{cells}\">\n"
    ))?;
    out.text(format_args!("<Points>\n"))?;
    let coordinates = mesh.points.iter().flat_map(|p| [p.x, p.y, 0.0]);
    array(
        out,
        "Float64",
        "Points",
        3,
        3 * n,
        coordinates.map(f64::to_le_bytes),
    )?;
    out.text(format_args!("</Points>\n"))?;
    write_cells(out, mesh, edges)?;
    out.text(format_args!("<PointData>\n"))?;
    attributes(out, mesh.attributes, 0)?;
    integers(
        out,
        "marker",
        mesh.markers.map(|markers| (markers.iter().copied(), n)),
    )?;
    out.text(format_args!("</PointData>\n<CellData>\n"))?;
    attributes(out, mesh.triangle_attributes, edges.len())?;
    write_cell_markers(out, mesh, edge_markers)?;
    out.text(format_args!(
        "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
    ))
}

/// Writes triangles, and after them edges.
fn write_cells(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    edges: &[[VertexId; 2]],
) -> Result<(), Error> {
    let (m, k) = (mesh.triangles.len(), edges.len());
    let cells = || (0..m + k).map(|i| cell(mesh, i));
    out.text(format_args!("<Cells>\n"))?;
    let nodes = cells().map(|cell| cell.len).sum();
    let of_cells = cells().flat_map(|cell| cell.nodes.into_iter().take(cell.len));
    let of_cells = of_cells.map(|v| i64::from(v.raw()).to_le_bytes());
    array(out, "Int64", "connectivity", 1, nodes, of_cells)?;
    let ends = cells().scan(0, |end, cell| {
        *end += cell.len as i64;
        Some(end.to_le_bytes())
    });
    array(out, "Int64", "offsets", 1, m + k, ends)?;
    let types = cells().map(|cell| [cell.kind]);
    array(out, "UInt8", "types", 1, m + k, types)?;
    out.text(format_args!("</Cells>\n"))
}

/// A cell: its type, and the first `len` of `nodes`.
pub(crate) struct Cell {
    pub kind: u8,
    pub len: usize,
    pub nodes: [VertexId; 6],
}

/// Makes a cell of a triangle or, behind these, of a constrained edge.
pub(crate) fn cell(mesh: &MeshView<'_>, i: usize) -> Cell {
    match (i.checked_sub(mesh.triangles.len()), mesh.constraints) {
        (Some(e), Some(constraints)) => line(mesh, constraints.edges[e], e),
        _ => triangle(mesh, i),
    }
}

/// Returns the regions of triangles, if they are known; −1 where there is none.
pub(crate) fn regions<'a>(mesh: &MeshView<'a>) -> Option<impl Iterator<Item = i32> + use<'a>> {
    let regions = mesh.constraints?.region_of.as_ref()?;
    Some(regions.iter().map(|r| r.map_or(-1, |r| r as i32)))
}

/// Makes the cell of a triangle. Midpoints are those opposite its corners, but VTK begins with the one
/// between the first two.
fn triangle(mesh: &MeshView<'_>, t: usize) -> Cell {
    let [a, b, c] = mesh.triangles[t];
    match mesh.middles.map(|middles| middles.of_triangles[t]) {
        Some([bc, ca, ab]) => Cell {
            kind: QUADRATIC_TRIANGLE,
            len: 6,
            nodes: [a, b, c, ab, bc, ca],
        },
        None => Cell {
            kind: TRIANGLE,
            len: 3,
            nodes: [a, b, c, a, a, a],
        },
    }
}

/// Makes the cell of a constrained edge; one without triangle has no midpoint.
fn line(mesh: &MeshView<'_>, [a, b]: [VertexId; 2], e: usize) -> Cell {
    match mesh.middles.and_then(|middles| middles.of_constrained[e]) {
        Some(middle) => Cell {
            kind: QUADRATIC_LINE,
            len: 3,
            nodes: [a, b, middle, a, a, a],
        },
        None => Cell {
            kind: LINE,
            len: 2,
            nodes: [a, b, a, a, a, a],
        },
    }
}

/// Writes the regions of triangles, −1 where there is none, and the markers of edges.
fn write_cell_markers(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    edge_markers: &[i32],
) -> Result<(), Error> {
    let Some(constraints) = mesh.constraints else {
        return Ok(());
    };
    let (m, k) = (mesh.triangles.len(), constraints.edges.len());
    let regions = regions(mesh);
    let regions = regions.map(|regions| (regions.chain(std::iter::repeat_n(-1, k)), m + k));
    integers(out, "region", regions)?;
    let none = std::iter::repeat_n(0, m);
    let markers = none.chain(edge_markers.iter().copied());
    integers(out, "marker", Some((markers, m + k)))
}

/// Writes attributes, with `further` values that are none.
fn attributes(out: &mut Output<'_>, attributes: &[Attribute], further: usize) -> Result<(), Error> {
    for Attribute { name, values } in attributes {
        let all = values.iter().copied();
        let all = all.chain(std::iter::repeat_n(f64::NAN, further));
        let len = values.len() + further;
        array(out, "Float64", name, 1, len, all.map(f64::to_le_bytes))?;
    }
    Ok(())
}

/// Writes an array of integers, if there is one, of which the number is known.
pub(super) fn integers(
    out: &mut Output<'_>,
    name: &str,
    values: Option<(impl Iterator<Item = i32>, usize)>,
) -> Result<(), Error> {
    match values {
        Some((values, len)) => array(out, "Int32", name, 1, len, values.map(i32::to_le_bytes)),
        None => Ok(()),
    }
}

/// Writes one array of `len` numbers of `N` bytes each.
pub(super) fn array<const N: usize>(
    out: &mut Output<'_>,
    kind: &str,
    name: &str,
    components: usize,
    len: usize,
    numbers: impl Iterator<Item = [u8; N]>,
) -> Result<(), Error> {
    let name = quick_xml::escape::escape(name);
    out.text(format_args!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">\n"
    ))?;
    let mut piece = Vec::with_capacity(PIECE + N);
    let mut text = String::new();
    piece.extend((len as u64 * N as u64).to_le_bytes());
    for (i, number) in numbers.enumerate() {
        piece.extend(number);
        if piece.len() >= PIECE {
            encode(out, &piece[..PIECE], &mut text)?;
            piece.drain(..PIECE);
        }
        if (i + 1).is_multiple_of(components) {
            out.end_row()?;
        }
    }
    encode(out, &piece, &mut text)?;
    out.text(format_args!("\n</DataArray>\n"))
}

fn encode(out: &mut Output<'_>, bytes: &[u8], text: &mut String) -> Result<(), Error> {
    text.clear();
    BASE64_STANDARD.encode_string(bytes, text);
    out.bytes(text.as_bytes())
}
