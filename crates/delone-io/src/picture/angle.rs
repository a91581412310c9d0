//! The smallest angle of a triangle, for its colour: rounded, and good enough for that.

use delone::Point;

/// Returns the smallest angle in degrees, from 0 to 60; 0 for what is no triangle.
pub(crate) fn smallest_angle([a, b, c]: [Point; 3]) -> f64 {
    let sides = [[c, b], [a, c], [b, a]].map(|[p, q]| [p.x - q.x, p.y - q.y]);
    // Scaled so that squares neither overflow nor vanish.
    let largest = sides
        .as_flattened()
        .iter()
        .fold(0.0, |m: f64, v| m.max(v.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return 0.0;
    }
    let sides = sides.map(|side| side.map(|v| v / largest));
    let length = |i: usize| sides[i][0].hypot(sides[i][1]);
    let shortest = (0..3)
        .min_by(|&i, &j| length(i).total_cmp(&length(j)))
        .unwrap_or(0);
    // The smallest angle lies opposite the shortest side, between the two others.
    let [u, v] = [sides[(shortest + 1) % 3], sides[(shortest + 2) % 3]];
    let cross = u[0] * v[1] - u[1] * v[0];
    let dot = u[0] * v[0] + u[1] * v[1];
    let angle = cross.abs().atan2(-dot).to_degrees();
    if angle.is_finite() {
        angle.min(60.0)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::smallest_angle;
    use delone::Point;

    fn angle(corners: [(f64, f64); 3]) -> f64 {
        smallest_angle(corners.map(Point::from))
    }

    #[test]
    fn known_angles() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} {b}");
        close(angle([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]), 45.0);
        close(angle([(0.0, 0.0), (2.0, 0.0), (1.0, 3f64.sqrt())]), 60.0);
        close(angle([(0.0, 0.0), (3f64.sqrt(), 0.0), (0.0, 1.0)]), 30.0);
        close(angle([(0.0, 0.0), (1e-200, 0.0), (0.0, 1e-200)]), 45.0);
    }

    #[test]
    fn degenerate_triangles_have_none() {
        assert_eq!(angle([(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)]), 0.0);
        assert_eq!(angle([(1.0, 1.0); 3]), 0.0);
        assert_eq!(angle([(0.0, 0.0), (0.0, 0.0), (1.0, 0.0)]), 0.0);
    }
}
