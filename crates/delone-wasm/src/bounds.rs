//! What numbers that come from outside must be, and what is said if they are not.

use delone::{Point, VertexId};

/// What a number counts.
pub(crate) struct Bound {
    one: &'static str,
    many: &'static str,
}

impl Bound {
    pub const POINT: Self = Self::new("point", "points");
    pub const SEGMENT: Self = Self::new("segment", "segments");
    pub const HOLE: Self = Self::new("hole", "holes");
    pub const REGION: Self = Self::new("region", "regions");
    pub const TRIANGLE: Self = Self::new("triangle", "triangles");

    const fn new(one: &'static str, many: &'static str) -> Self {
        Self { one, many }
    }
}

/// Requires that there is a thing of a number.
pub(crate) fn within(bound: Bound, number: usize, count: usize) -> Result<(), String> {
    if number < count {
        return Ok(());
    }
    let Bound { one, many } = bound;
    Err(match count {
        0 => format!("there is no {one} {number}: there are no {many}"),
        1 => format!("there is no {one} {number}: there is only {one} 0"),
        _ => format!(
            "there is no {one} {number}: there are {count} {many}, 0 to {}",
            count - 1
        ),
    })
}

/// Requires that a place is one of the plane.
pub(crate) fn finite(at: [Option<f64>; 2]) -> Result<Point, String> {
    match at {
        [Some(x), Some(y)] if x.is_finite() && y.is_finite() => Ok(Point::new(x, y)),
        _ => {
            let [x, y] = at.map(|c| c.map_or_else(|| "no number".to_owned(), |c| c.to_string()));
            Err(format!(
                "({x}, {y}) is no place: coordinates must be finite"
            ))
        }
    }
}

/// Requires that a segment joins two different points.
pub(crate) fn pair(ends: [usize; 2], points: usize) -> Result<[VertexId; 2], String> {
    for end in ends {
        within(Bound::POINT, end, points)?;
    }
    match ends {
        [a, b] if a == b => Err(format!("a segment from point {a} to itself has no length")),
        _ => Ok(ends.map(VertexId::new)),
    }
}
