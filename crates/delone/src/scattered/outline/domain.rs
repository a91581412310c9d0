//! A domain that is given instead of an outer polygon: any simple polygon.
//!
//! *Cost*: O(n log n) in practice.

use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point, Pslg};

/// Returns the corners of a simple polygon counter-clockwise, each once. The first may be given once more at the
/// end, and each several times in a row; corners may be straight.
///
/// # Errors
/// [`Error::BadDomain`] if the polygon is not simple.
pub(super) fn corners_of(given: &[Point]) -> Result<Vec<Point>, Error> {
    let mut corners: Vec<Point> = given
        .iter()
        .map(|p| Point::new(p.x + 0.0, p.y + 0.0))
        .collect();
    if !corners.iter().all(Point::is_finite) {
        return Err(bad("the coordinates of its corners must be finite"));
    }
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    if corners.len() < 3 {
        return Err(bad("it must have three different corners at least"));
    }
    require_simple(&corners)?;
    if !is_counter_clockwise(&corners) {
        // The first one stays the first.
        corners[1..].reverse();
    }
    Ok(corners)
}

fn require_simple(corners: &[Point]) -> Result<(), Error> {
    let mut ring = Pslg::from_points(corners.iter().copied());
    // More than 32 bits can number are refused by what follows.
    ring.add_ring(0..corners.len() as u32);
    let facts = ring.facts(0, &())?;
    if facts.duplicates.count > 0 {
        Err(bad("it comes twice to the same corner"))
    } else if facts.crossings.count > 0 {
        Err(bad("two of its sides cross"))
    } else if !facts.is_clean() {
        Err(bad("one of its corners lies on another side"))
    } else {
        Ok(())
    }
}

/// The leftmost corner, of several the lowest, is convex, and strictly so, because sides do not overlap.
fn is_counter_clockwise(corners: &[Point]) -> bool {
    let n = corners.len();
    let leftmost = (0..n).min_by(|&i, &j| corners[i].lex_cmp(&corners[j]));
    leftmost.is_some_and(|i| {
        let [before, after] = [(i + n - 1) % n, (i + 1) % n].map(|k| corners[k]);
        orient2d(before, corners[i], after) == Orientation::Left
    })
}

fn bad(why: &'static str) -> Error {
    Error::BadDomain { why }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(given: &[[f64; 2]]) -> Result<Vec<Point>, Error> {
        corners_of(&given.iter().copied().map(Point::from).collect::<Vec<_>>())
    }

    #[test]
    fn simple_polygons_are_turned_counter_clockwise() {
        let dart = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
        let expected = dart.map(Point::from).to_vec();
        assert_eq!(corners(&dart), Ok(expected.clone()));
        let clockwise = [dart[0], dart[3], dart[2], dart[1]];
        assert_eq!(corners(&clockwise), Ok(expected.clone()));
        let closed = [
            dart[0], dart[1], dart[1], dart[2], dart[3], dart[0], dart[0],
        ];
        assert_eq!(corners(&closed), Ok(expected));
        // A straight corner.
        let straight = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 5e-324]];
        assert_eq!(corners(&straight).map(|c| c.len()), Ok(4));
    }

    #[test]
    fn others_are_refused() {
        let refused: [&[[f64; 2]]; 8] = [
            &[],
            &[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]],
            &[[0.0, 0.0], [1.0, 0.0], [f64::NAN, 1.0]],
            // On one line.
            &[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]],
            // A bow tie, and one that touches itself in a corner, and in a side.
            &[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]],
            &[
                [0.0, 0.0],
                [2.0, 2.0],
                [2.0, 0.0],
                [0.0, 0.0],
                [0.0, 2.0],
                [-1.0, 1.0],
            ],
            &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]],
            // There and back.
            &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 2.0]],
        ];
        for given in refused {
            let found = corners(given);
            assert!(
                matches!(found, Err(Error::BadDomain { .. })),
                "{given:?}: {found:?}"
            );
        }
    }
}
