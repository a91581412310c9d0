//! `.dxf`: drawings of AutoCAD and its kin, text and binary, of any release.
//!
//! After the *DXF Reference* of Autodesk. Read are POINT, LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE,
//! SPLINE (by control points), 3DFACE, SOLID, TRACE, and INSERT of blocks, with arrays and in one another; what
//! has coordinates of its own, by the direction of extrusion, is turned. All others are counted and named in a
//! note, as is what lies on paper.
//!
//! - Curves become [polylines](crate::curve).
//! - Segments are marked by layer: 1 for the layer that appears first, and so on, whichever are picked. What a
//!   block has on layer 0 is on the layer of the insertion. Layers that are frozen or off are read as others
//!   are, and named in a note.
//! - z becomes an attribute, unless it is zero everywhere. Units (`$INSUNITS`) change nothing.
//! - The usual rule is even–odd if all lines close, bit for bit, and else the hull; a file of faces is the
//!   union of these.
//!
//! Written is release 12, text, which everything reads.

mod assembly;
mod codes;
mod drawing;
mod entity;
mod read;
mod write;

pub(crate) use read::read_domain;
pub(crate) use write::write;

use crate::scan;

/// Tells whether the bytes begin like a drawing: with a section, or with a comment.
pub(crate) fn sniff(head: &[u8]) -> bool {
    if head.starts_with(b"AutoCAD Binary DXF") {
        return true;
    }
    let mut lines = scan::without_mark(head).split(|b| matches!(b, b'\n' | b'\r'));
    let mut next = || lines.find(|line| !line.is_empty()).map(<[u8]>::trim_ascii);
    match (next(), next()) {
        (Some(b"0"), Some(b"SECTION")) => true,
        (Some(b"999"), Some(_)) => matches!(next(), Some(b"0" | b"999")),
        _ => false,
    }
}
