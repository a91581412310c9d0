//! What makers of fields require of what they are given.

use crate::{Error, Point, VertexId};

/// Refuses points that are nowhere.
pub(super) fn require_finite<'p>(points: impl IntoIterator<Item = &'p Point>) -> Result<(), Error> {
    match points.into_iter().enumerate().find(|(_, p)| !p.is_finite()) {
        Some((index, &Point { x, y })) => Err(Error::NotFinite { index, x, y }),
        None => Ok(()),
    }
}

/// Refuses a number unless it `is_right`.
pub(super) fn require(what: &'static str, given: f64, is_right: bool) -> Result<(), Error> {
    match is_right {
        true => Ok(()),
        false => Err(Error::BadQuality { what, given }),
    }
}

/// Requires a value for each of so many things.
pub(super) fn require_number(given: usize, expected: usize, of: &'static str) -> Result<(), Error> {
    match given == expected {
        true => Ok(()),
        false => Err(Error::SizesMissing {
            given,
            expected,
            of,
        }),
    }
}

/// Refuses sizes that are not positive numbers.
pub(super) fn require_sizes(sizes: &[f64]) -> Result<(), Error> {
    let is_wrong = |size: f64| !(size > 0.0 && size < f64::INFINITY);
    match sizes.iter().position(|&size| is_wrong(size)) {
        Some(index) => Err(Error::BadSize {
            index,
            given: sizes[index],
        }),
        None => Ok(()),
    }
}

/// Refuses corners that are no points.
pub(super) fn require_corners(triangles: &[[VertexId; 3]], points: usize) -> Result<(), Error> {
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|v| v.index() >= points) {
            return Err(Error::BadTriangle {
                triangle,
                vertex,
                points,
            });
        }
    }
    Ok(())
}
