//! Formats whose file holds all of it: points, domains and meshes are written by the same function.

use super::WriteOptions;
use crate::points::unsupported;
use crate::target::Output;
use crate::{Error, Format, MeshView, dxf, medit, msh, obj, off, ply, stl, tikz, vtk, vtu};

/// Writes a mesh, a domain (no triangles) or points (no constraints either) in one of these formats; `markers`
/// are those of the constrained edges.
pub(super) fn write(
    out: &mut Output<'_>,
    format: Format,
    mesh: &MeshView<'_>,
    markers: &[i32],
    options: &WriteOptions,
) -> Result<(), Error> {
    match format {
        Format::Vtu => vtu::write(out, mesh, markers),
        Format::Vtk => vtk::write(out, mesh, markers, options),
        Format::Msh => msh::write_4(out, mesh, markers, options),
        Format::Msh2 => msh::write_2(out, mesh, markers, options),
        Format::Medit => medit::write(out, mesh, markers, options),
        Format::Obj => obj::write(out, mesh, markers, options),
        Format::Off => off::write(out, mesh, markers, options),
        Format::Ply => ply::write(out, mesh, markers, options),
        Format::Stl => stl::write(out, mesh, markers, options),
        Format::Dxf => dxf::write(out, mesh, markers, options),
        Format::Tikz => tikz::write(out, mesh, markers, options),
        _ => Err(unsupported(
            out.file(),
            format,
            "be written",
            Format::writes_mesh,
        )),
    }
}
