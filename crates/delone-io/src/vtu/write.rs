//! Writing: one element for each array, numbers in base64 behind their count of bytes.

use super::TRIANGLE;
use crate::target::Output;
use crate::{Attribute, Error, MeshView};
use base64::prelude::{BASE64_STANDARD, Engine};

/// Bytes encoded at once; divisible by 3, so that pieces join without padding.
const PIECE: usize = 3 << 13;

/// Writes points, triangles and attributes.
pub(crate) fn write(out: &mut Output<'_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let (n, m) = (mesh.points.len(), mesh.triangles.len());
    out.text(format_args!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{m}\">\n"
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
    out.text(format_args!("</Points>\n<Cells>\n"))?;
    let corners = mesh.triangles.as_flattened().iter();
    let corners = corners.map(|v| i64::from(v.raw()).to_le_bytes());
    array(out, "Int64", "connectivity", 1, 3 * m, corners)?;
    let ends = (1..=m as i64).map(|t| (3 * t).to_le_bytes());
    array(out, "Int64", "offsets", 1, m, ends)?;
    array(
        out,
        "UInt8",
        "types",
        1,
        m,
        std::iter::repeat_n([TRIANGLE], m),
    )?;
    out.text(format_args!("</Cells>\n"))?;
    data(out, "PointData", mesh.attributes, mesh.markers)?;
    data(out, "CellData", mesh.triangle_attributes, None)?;
    out.text(format_args!("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"))
}

fn data(
    out: &mut Output<'_>,
    element: &str,
    attributes: &[Attribute],
    markers: Option<&[i32]>,
) -> Result<(), Error> {
    out.text(format_args!("<{element}>\n"))?;
    for Attribute { name, values } in attributes {
        let bytes = values.iter().map(|v| v.to_le_bytes());
        array(out, "Float64", name, 1, values.len(), bytes)?;
    }
    if let Some(markers) = markers {
        let bytes = markers.iter().map(|m| m.to_le_bytes());
        array(out, "Int32", "marker", 1, markers.len(), bytes)?;
    }
    out.text(format_args!("</{element}>\n"))
}

/// Writes one array of `len` numbers of `N` bytes each.
fn array<const N: usize>(
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
