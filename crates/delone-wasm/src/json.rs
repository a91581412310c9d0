//! JSON texts, as which structured values cross the border; and arrays, as which rows do.

use crate::Trouble;
use delone::{Point, VertexId};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Reads options; none are the usual ones.
pub(crate) fn options<T: DeserializeOwned + Default>(text: Option<&str>) -> Result<T, Trouble> {
    match text {
        Some(text) if !text.trim().is_empty() => Ok(serde_json::from_str(text)?),
        _ => Ok(T::default()),
    }
}

/// Writes a value.
pub(crate) fn write(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("bug: numbers and strings always serialise")
}

/// Lists coordinates, x and y in turns.
pub(crate) fn coordinates(points: impl IntoIterator<Item = Point>) -> Vec<f64> {
    let points = points.into_iter();
    points.flat_map(|p| [p.x, p.y]).collect()
}

/// Lists the numbers of vertices, row by row.
pub(crate) fn indices<const N: usize>(rows: impl IntoIterator<Item = [VertexId; N]>) -> Vec<u32> {
    let rows = rows.into_iter();
    rows.flat_map(|row| row.map(|v| v.index() as u32)).collect()
}
