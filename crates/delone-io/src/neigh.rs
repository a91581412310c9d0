//! `.neigh`: neighbours of triangles, of Triangle; written only.
//!
//! Header `m 3`, then a row `number n0 n1 n2` for each triangle: the triangle beyond the edge
//! opposite the first, second and third corner, −1 where there is none.

use crate::Error;
use crate::target::Output;
use crate::topology::{NO_NEIGHBOR, Topology};

/// Writes the neighbours, numbered from `base`.
pub(crate) fn write(out: &mut Output<'_>, topology: &Topology, base: usize) -> Result<(), Error> {
    out.text(format_args!("{} 3\n", topology.neighbors.len()))?;
    for (t, neighbors) in topology.neighbors.iter().enumerate() {
        out.integer((t + base) as i64);
        for &n in neighbors {
            out.blank();
            let shown = (n != NO_NEIGHBOR).then_some((n as usize + base) as i64);
            out.integer(shown.unwrap_or(-1));
        }
        out.end_line()?;
    }
    Ok(())
}
