//! `.edge`: edges of Triangle, written only.
//!
//! Header `e 1`, then a row `number a b marker` for each edge; the marker is that of
//! a constrained edge, if it has one, otherwise 1 on the boundary.

use crate::Error;
use crate::target::Output;
use crate::topology::Topology;

/// Writes the edges with their markers, everything numbered from `base`.
pub(crate) fn write(
    out: &mut Output<'_>,
    topology: &Topology,
    markers: &[i32],
    base: usize,
) -> Result<(), Error> {
    out.text(format_args!("{} 1\n", topology.edges.len()))?;
    for (i, (edge, &marker)) in topology.edges.iter().zip(markers).enumerate() {
        out.integer((i + base) as i64);
        for v in edge.ends {
            out.blank();
            out.integer((v as usize + base) as i64);
        }
        out.blank();
        out.integer(marker.into());
        out.end_line()?;
    }
    Ok(())
}
