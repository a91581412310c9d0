//! How large a drawing is beside its coordinates, and how long beside its width.

use super::trouble::{Diagnosis, Kind, Trouble};
use crate::Point;

/// Units in the last place that an extent should have.
const FEW_UNITS: f64 = 16_777_216.0;

/// A bounding box as many times as long as wide is worth a note.
const LONG: f64 = 1000.0;

/// Looks at the bounding box of the points.
pub(super) fn examine(points: &[Point], found: &mut Diagnosis, limit: usize) {
    let Some((&first, rest)) = points.split_first() else {
        return;
    };
    let [low, high] = rest.iter().fold([first; 2], |[low, high], p| {
        [
            Point::new(low.x.min(p.x), low.y.min(p.y)),
            Point::new(high.x.max(p.x), high.y.max(p.y)),
        ]
    });
    // Halved, so that nothing overflows.
    let [width, height] = [high.x / 2.0 - low.x / 2.0, high.y / 2.0 - low.y / 2.0];
    let (longer, shorter) = (width.max(height), width.min(height));
    let whole = |size: f64| Trouble {
        at: Some(low),
        to: Some(high),
        size: Some(size),
        ..Trouble::default()
    };
    let largest = [low.x, low.y, high.x, high.y].map(f64::abs);
    let largest = largest.into_iter().fold(0.0, f64::max);
    let unit = largest / 2.0 - (largest / 2.0).next_down();
    if longer > 0.0 && unit > 0.0 && longer / unit < FEW_UNITS {
        found.add_all(Kind::FarAway, vec![whole(longer / unit)], limit);
    }
    if shorter > 0.0 && longer / shorter >= LONG {
        found.add_all(Kind::Elongated, vec![whole(longer / shorter)], limit);
    }
}
