//! `.off`: Geomview's points and faces.
//!
//! *Object File Format*, <http://www.geomview.org/docs/html/OFF.html>: the header `OFF`, perhaps with `ST`, `C`, `N`
//! before it, which may also be missing; counts of vertices, faces and edges, on its line or the next; a row for each
//! vertex and one for each face. `#` starts a comment. Faces have three corners; colours behind these are not read.
//! What vertices have besides x and y are attributes: `z` (unless zero everywhere), normals `nx`, `ny`, `nz`, colours
//! `red`, `green`, `blue`, `alpha` and texture coordinates `s`, `t`, as the header says, and further columns by their
//! place. `4OFF`, `nOFF` and binary files are refused.
//!
//! Written are points with z (0 where there is none) and triangles; all else has no place.

mod read;
mod write;

pub(crate) use read::{read_mesh, sniff};
pub(crate) use write::write;
