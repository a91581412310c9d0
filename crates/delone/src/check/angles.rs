//! How many triangles have an angle below a bound: exactly.

use crate::pace::Pace;
use crate::predicates::angles_are_at_least;
use crate::{Angle, Error, Phase, Point, VertexId, Watch};

/// Triangles below an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Below {
    /// The tangent of the angle as a number, which is what angles were compared with.
    pub tangent: f64,
    /// How many triangles have an angle of a smaller one.
    pub triangles: usize,
}

/// Counts the triangles that have an angle below `bound`, whose tangent is rounded once; the comparison with that
/// is exact. Triangles must be counter-clockwise; a bound of 90 degrees or more counts as one of 60.
///
/// ```
/// use delone::{Angle, check};
/// let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])?;
/// let count = |degrees| check::count_below(t.points(), t.triangles(), Angle::degrees(degrees), &());
/// assert_eq!((count(44.999)?.triangles, count(45.001)?.triangles), (0, 1));
/// # Ok::<(), delone::Error>(())
/// ```
///
/// # Errors
/// [`Error::Cancelled`] if the watch says so.
///
/// # Panics
/// If a triangle names no point.
///
/// *Cost*: about 10 ns a triangle.
pub fn count_below(
    points: &[Point],
    triangles: &[[VertexId; 3]],
    bound: Angle,
    watch: &dyn Watch,
) -> Result<Below, Error> {
    let degrees = bound.to_degrees();
    let degrees = if degrees < 90.0 {
        degrees.max(0.0)
    } else {
        60.0
    };
    let tangent = libm::tan(degrees.to_radians());
    let mut pace = Pace::new(watch, Phase::Check, triangles.len() as u64);
    let mut below = 0;
    for corners in triangles {
        pace.step()?;
        let corners = corners.map(|v| points[v.index()]);
        below += usize::from(!angles_are_at_least(corners, tangent));
    }
    pace.finish();
    Ok(Below {
        tangent,
        triangles: below,
    })
}
