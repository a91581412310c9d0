//! Reading constrained edges: rows of two ends and a marker.

use super::{Array, Kind};
use crate::{Constraints, Error, Place, Problem};
use delone::Watch;

/// Reads constrained edges over so many vertices; `None` if there are none.
pub(crate) fn read_segments(
    file: &str,
    bytes: &[u8],
    num_vertices: usize,
    watch: &dyn Watch,
) -> Result<Option<Constraints>, Error> {
    let array = Array::parse(file, bytes)?;
    if array.columns != 3 || array.kind == Kind::Float {
        return Err(array.problem(format!(
            "shape {} holds no segments: must be integers (k, 3), two ends and a marker",
            array.shape
        )));
    }
    let mut edges = Vec::with_capacity(array.rows);
    let mut markers = Vec::with_capacity(array.rows);
    for row in 0..array.rows {
        array.poll(row * 3, watch)?;
        let end = |k| array.vertex((row, k), "segment", num_vertices);
        edges.push([end(0)?, end(1)?]);
        let marker = array.integer(row, 2);
        markers.push(i32::try_from(marker).map_err(|_| {
            let problem = Problem::Other(format!("marker {marker} does not fit 32 bits"));
            array.malformed(Place::Byte(array.offset(row, 2) as u64), problem)
        })?);
    }
    Ok((!edges.is_empty()).then_some(Constraints {
        edges,
        markers: Some(markers),
        ..Constraints::default()
    }))
}
