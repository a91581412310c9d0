//! Writing contour lines: one feature each.

use super::write::List;
use crate::Error;
use crate::target::Output;
use delone::surface::Contour;

/// Writes lines, rings back to their first point, with their levels as property `level`.
pub(crate) fn write_contours(out: &mut Output<'_>, contours: &[Contour]) -> Result<(), Error> {
    let mut list = List::begin(out)?;
    for line in contours {
        list.next(|out| {
            out.bytes(b"{\"level\":")?;
            out.number(line.value);
            out.bytes(b"},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[")?;
            let back = line.points.first().filter(|_| line.is_closed);
            for (i, p) in line.points.iter().chain(back).enumerate() {
                out.bytes(if i == 0 { b"[" } else { b",[" })?;
                out.number(p.x);
                out.separator(b',');
                out.number(p.y);
                out.bytes(b"]")?;
            }
            out.bytes(b"]}")
        })?;
    }
    list.end()
}
