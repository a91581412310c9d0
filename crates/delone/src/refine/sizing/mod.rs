//! How large triangles may be, place by place.
//!
//! A field is anything that has a longest edge for each place; a closure will do. Ready-made are
//! [`Background`] (sizes at points, linear in between), [`Areas`] (a largest area for each triangle of a
//! mesh), [`Distance`] (small at features, growing away from them) and [`Smallest`] of several. Sizes that
//! are the same everywhere need no field: [`Quality`](crate::Quality) has them.
//!
//! *Cost*: fields are asked about once for each triangle that is made, perhaps from several threads. The
//! ready-made ones answer in 50 to 200 ns if places follow each other closely, as they do then; in up to
//! a microsecond if they are scattered over a million of features, which no cache holds. They use nothing but +, −, ×, ÷ and √, so every machine gives
//! the same answer.

mod areas;
mod background;
mod distance;
mod input;
mod smallest;
mod tree;
mod unit;

pub use areas::Areas;
pub use background::Background;
pub use distance::Distance;
pub use smallest::Smallest;

use crate::Point;

/// Bounds on triangles that depend on the place.
///
/// A triangle obeys the field if its longest edge is at most [`max_edge`](Self::max_edge) at its
/// centroid, and its area at most [`max_area`](Self::max_area) there. A value that is not positive, or
/// NaN, counts as no bound. The same position must always give the same values; for the same mesh on
/// every machine they must not depend on a transcendental function of the standard library.
///
/// ```
/// use delone::{Point, SizingField};
/// let field = |p: Point| 0.01 + 0.1 * p.x.abs();
/// assert_eq!(field.max_edge(Point::new(0.0, 5.0)), 0.01);
/// ```
pub trait SizingField: Sync {
    /// Returns the longest that an edge may be near `at`, in units of the coordinates.
    fn max_edge(&self, at: Point) -> f64;

    /// Returns the largest that the area of a triangle may be near `at`.
    fn max_area(&self, at: Point) -> f64 {
        let _ = at;
        f64::INFINITY
    }
}

impl<F: Fn(Point) -> f64 + Sync> SizingField for F {
    fn max_edge(&self, at: Point) -> f64 {
        self(at)
    }
}
