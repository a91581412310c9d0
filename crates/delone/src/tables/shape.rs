//! Lengths, angles and areas as the thesis compares them: in rounded numbers, but with the same bits on
//! every machine, for there is nothing in them but the four operations and the square root.

use crate::Point;

/// The length of an edge: positive and finite, whatever the coordinates.
pub(crate) fn length(a: Point, b: Point) -> f64 {
    let [dx, dy] = [b.x - a.x, b.y - a.y].map(|d| d.clamp(-f64::MAX, f64::MAX).abs());
    let squared = dx * dx + dy * dy;
    if (1e-280..1e300).contains(&squared) {
        return squared.sqrt();
    }
    // The squares overflow or lose bits: take them of the ratio.
    let (longer, shorter) = (dx.max(dy), dx.min(dy));
    let ratio = shorter / longer;
    (longer * (1.0 + ratio * ratio).sqrt()).min(f64::MAX)
}

/// The area of a triangle, in either orientation; may round to zero or infinity.
pub(crate) fn area([a, b, c]: [Point; 3]) -> f64 {
    let [[ux, uy], [vx, vy]] = [b, c].map(|p| [p.x - a.x, p.y - a.y]);
    0.5 * (ux * vy - uy * vx).abs()
}

/// The circumcenter of a triangle; not finite, or far off, if coordinates leave no better.
pub(crate) fn circumcenter([a, b, c]: [Point; 3]) -> Point {
    let [[ux, uy], [vx, vy]] = [b, c].map(|p| [p.x - a.x, p.y - a.y]);
    let doubled = 2.0 * (ux * vy - uy * vx);
    let [u, v] = [ux * ux + uy * uy, vx * vx + vy * vy];
    let [x, y] = [vy * u - uy * v, ux * v - vx * u];
    Point::new(a.x + x / doubled, a.y + y / doubled)
}

/// The middle of an edge, each coordinate rounded once.
pub(crate) fn middle(a: Point, b: Point) -> Point {
    Point::new(f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y))
}

/// The shape of a triangle, from the lengths of its edges by their positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shape {
    /// The cosine of the smallest angle: the larger, the skinnier.
    pub cosine: f64,
    /// The cosine of the largest angle.
    pub largest_cosine: f64,
    /// The position of the shortest edge, of equals the lowest.
    pub shortest: usize,
    /// The position of the longest edge, of equals the lowest.
    pub longest: usize,
}

impl Shape {
    pub fn of(lengths: [f64; 3]) -> Self {
        let (mut shortest, mut longest) = (0, 0);
        for k in [1, 2] {
            if lengths[k] < lengths[shortest] {
                shortest = k;
            }
            if lengths[k] > lengths[longest] {
                longest = k;
            }
        }
        // By ratios nothing can overflow; the two longer edges are at least half of the longest.
        let ratios = lengths.map(|l| l / lengths[longest]);
        let cosine = |opposite: usize| {
            let [a, b, c] = [0, 1, 2].map(|k| ratios[(opposite + k) % 3]);
            (b * b + c * c - a * a) / (2.0 * b * c)
        };
        Self {
            cosine: cosine(shortest),
            largest_cosine: cosine(longest),
            shortest,
            longest,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_right_and_finite_for_all_sizes() {
        for scale in [5e-324, 1e-300, 1e-150, 1.0, 1e150, 1e300] {
            let c = length(Point::new(0.0, 0.0), Point::new(3.0 * scale, -4.0 * scale));
            assert!((c / (5.0 * scale) - 1.0).abs() < 1e-15, "{scale}: {c}");
        }
        let far = [-1.7e308, 1.7e308].map(|c| Point::new(c, c));
        assert_eq!(length(far[0], far[1]), f64::MAX);
    }

    #[test]
    fn shapes_name_the_first_of_equals() {
        let isosceles = Shape::of([2.0, 2.0, 1.0]);
        assert_eq!((isosceles.shortest, isosceles.longest), (2, 0));
        assert_eq!(isosceles.cosine, 0.875);
        let flat = Shape::of([1.0, 1.0, 1.9]);
        assert_eq!((flat.shortest, flat.longest), (0, 2));
        let right = Shape::of([3e200, 5e200, 4e200]);
        assert_eq!((right.shortest, right.longest), (0, 1));
        assert!((right.cosine - 0.8).abs() < 1e-15);
        assert!(right.largest_cosine.abs() < 1e-15);
    }

    #[test]
    fn circumcenters_are_equally_far() {
        let corners = [(1.0, 0.0), (3.0, 1.0), (2.0, 2.5)].map(Point::from);
        let center = circumcenter(corners);
        let radii = corners.map(|p| length(p, center));
        assert!(radii.iter().all(|r| (r / radii[0] - 1.0).abs() < 1e-15));
        assert_eq!(area(corners), 2.0);
    }
}
