//! Cuts polygons to a window (I. Sutherland and G. Hodgman, 1974): what lies far beyond it has
//! coordinates that viewers cannot cope with.

/// Returns the part of a convex polygon that lies in the square from -1 to 1. Of a line of two points the
/// first two are the ends of what is left.
pub(super) fn to_window(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut left = corners.to_vec();
    for axis in [0, 1] {
        for sign in [-1.0, 1.0] {
            left = to_half_plane(&left, |p| 1.0 - sign * p[axis]);
        }
    }
    left
}

/// Keeps what has a depth that is not negative.
fn to_half_plane(corners: &[[f64; 2]], depth: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let [from, to] = [a, b].map(&depth);
        if from >= 0.0 {
            kept.push(a);
        }
        if (from >= 0.0) != (to >= 0.0) {
            let t = from / (from - to);
            kept.push([0, 1].map(|k| a[k] + t * (b[k] - a[k])));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::to_window;

    #[test]
    fn what_lies_within_stays() {
        let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, -1.0]];
        assert_eq!(to_window(&triangle), triangle);
        assert!(to_window(&[[2.0, 2.0], [3.0, 2.0], [2.0, 3.0]]).is_empty());
    }

    #[test]
    fn what_covers_the_window_becomes_the_window() {
        let found = to_window(&[[-1e9, -1e9], [1e9, -1e9], [0.0, 1e9]]);
        assert_eq!(found.len(), 4);
        assert!(
            found
                .as_flattened()
                .iter()
                .all(|c| (c.abs() - 1.0).abs() < 1e-6)
        );
    }

    #[test]
    fn lines_keep_their_direction() {
        let cases = [
            ([[-4.0, -2.0], [4.0, 2.0]], [[-1.0, -0.5], [1.0, 0.5]]),
            ([[0.5, 0.0], [4.0, 0.0]], [[0.5, 0.0], [1.0, 0.0]]),
            ([[0.0, 3.0], [0.0, 0.5]], [[0.0, 1.0], [0.0, 0.5]]),
        ];
        for (line, expected) in cases {
            let found = to_window(&line);
            let mut ends = [found[0], found[1]];
            let mut expected = expected;
            for line in [&mut ends, &mut expected] {
                line.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            }
            assert_eq!(ends, expected);
        }
        assert!(to_window(&[[-3.0, 0.0], [0.0, 3.0]]).is_empty());
    }
}
