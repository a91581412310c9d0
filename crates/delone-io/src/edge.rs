//! `.edge`: edges of Triangle, written only.
//!
//! Header `e 1`, then a row `number a b marker` for each edge; the marker is that of
//! a constrained edge, if it has one, otherwise 1 on the boundary. Without markers, the header
//! says 0.

use crate::Error;
use crate::target::Output;
use crate::topology::Topology;

/// Writes the edges, perhaps with their markers, everything numbered from `base`.
pub(crate) fn write(
    out: &mut Output<'_>,
    topology: &Topology,
    markers: Option<&[i32]>,
    base: usize,
) -> Result<(), Error> {
    let has_markers = usize::from(markers.is_some());
    out.text(format_args!("{} {has_markers}\n", topology.edges.len()))?;
    for (i, edge) in topology.edges.iter().enumerate() {
        out.integer((i + base) as i64);
        for v in edge.ends {
            out.blank();
            out.integer((v as usize + base) as i64);
        }
        if let Some(markers) = markers {
            out.blank();
            out.integer(markers[i].into());
        }
        out.end_line()?;
    }
    Ok(())
}
