//! `.vtk`: VTK's legacy format, as text or bytes.
//!
//! *VTK File Formats*, "Simple legacy formats", <https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html>,
//! versions 1.0 to 5.1. Read are `UNSTRUCTURED_GRID` and `POLYDATA` with the cells that `.vtu` may have, data of points and
//! cells of every kind but strings; dataset fields and tables of colours are passed over, and metadata. Written is version
//! 3.0, an unstructured grid with what a `.vtu` holds, numbers in bytes unless text is asked for.

mod read;
mod values;
mod write;

pub(crate) use read::read_mesh;
pub(crate) use write::write;

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    head.starts_with(b"# vtk DataFile")
}
