//! `.vtu`: VTK's unstructured grid in XML, as ParaView, meshio and PyVista open it.
//!
//! *VTK File Formats*, <https://docs.vtk.org/en/latest/vtk_file_formats/index.html>. Written are the points
//! with z = 0, the triangles, attributes as point and cell data, all arrays inline in base64 without
//! compression. Read are triangles in inline base64 or ASCII arrays; appended and compressed data
//! are not.

mod read;
mod write;

pub(crate) use read::{read_mesh, sniff};
pub(crate) use write::write;

/// VTK's number for a triangle.
const TRIANGLE: u8 = 5;
