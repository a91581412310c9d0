//! Exact decisions about points whose coordinates are multiples of 2⁻⁵³ in [0, 1].
//!
//! Such coordinates are integers up to 2⁵³ in units of 2⁻⁵³; the terms of an orientation then need
//! 107 bits.

/// 2⁵³.
const UNITS: f64 = 9_007_199_254_740_992.0;

/// Rounds to the nearest multiple of 2⁻⁵³.
pub fn snap(coordinate: f64) -> f64 {
    (coordinate * UNITS).round() / UNITS
}

/// Tells whether two closed segments have a point in common.
pub fn meet(s: [[f64; 2]; 2], t: [[f64; 2]; 2]) -> bool {
    let [[a, b], [c, d]] = [s, t].map(|ends| ends.map(integers));
    // Of segments on one line only the boxes tell, and those of segments that meet overlap anyway.
    boxes_overlap([a, b], [c, d]) && !same_side(a, b, c, d) && !same_side(c, d, a, b)
}

fn boxes_overlap([a, b]: [[i128; 2]; 2], [c, d]: [[i128; 2]; 2]) -> bool {
    (0..2).all(|k| a[k].max(b[k]) >= c[k].min(d[k]) && c[k].max(d[k]) >= a[k].min(b[k]))
}

fn integers(point: [f64; 2]) -> [i128; 2] {
    point.map(|c| (c * UNITS) as i128)
}

/// Tells whether `c` and `d` lie strictly on one side of the line through `a` and `b`.
fn same_side(a: [i128; 2], b: [i128; 2], c: [i128; 2], d: [i128; 2]) -> bool {
    orientation(a, b, c) * orientation(a, b, d) > 0
}

/// Returns the sign of the area of a triangle, counter-clockwise positive.
fn orientation(a: [i128; 2], b: [i128; 2], c: [i128; 2]) -> i128 {
    let [ux, uy] = [b[0] - a[0], b[1] - a[1]];
    let [vx, vy] = [c[0] - a[0], c[1] - a[1]];
    (ux * vy - uy * vx).signum()
}

#[cfg(test)]
mod tests {
    use super::{meet, snap};

    #[test]
    fn segments_meet_when_they_share_a_point() {
        let [o, e, n, m] = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]];
        assert!(meet([o, m], [e, n]));
        assert!(meet([o, e], [[0.25, 0.0], m]));
        assert!(meet([o, e], [e, m]));
        assert!(!meet([o, e], [n, m]));
        assert!(!meet([o, [0.25, 0.25]], [[0.375, 0.375], m]));
        assert!(meet([o, [0.375, 0.375]], [[0.25, 0.25], m]));
        let beside = [0.25, 1.0 / 9_007_199_254_740_992.0];
        assert!(!meet([o, e], [beside, m]));
    }

    #[test]
    fn snapping_keeps_multiples_and_moves_others_by_half_a_unit_at_most() {
        assert_eq!(snap(0.75), 0.75);
        let third = 1.0 / 3.0 / 1024.0;
        assert_ne!(snap(third), third);
        assert!((snap(third) - third).abs() <= 0.5f64.powi(54));
    }
}
