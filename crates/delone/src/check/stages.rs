//! Which arithmetic the local tests of a triangulation take: a function of the set of triangles alone.
//!
//! The tests are those on which the proof rests: for each triangle its orientation, for each edge that two
//! triangles have and that is not constrained whether the vertex on one side lies in the circle of the other. To
//! make the counts canonical, triangles begin at their lexicographically smallest corner, and edges go from the
//! smaller end to the larger. What a verification asks beyond that, of segments and seeds, is not counted.

use super::adjacency::{Adjacency, STEPS_PER_TRIANGLE};
use super::{Defects, MOST_TRIANGLES};
use crate::pace::Pace;
use crate::predicates::stage::{self, Stage};
use crate::{Error, HalfEdgeId, Phase, Point, VertexId, Watch};

/// How many tests of one kind each stage has decided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StageCounts {
    /// By the filter.
    pub filter: u64,
    /// By integers of fixed width.
    pub integer: u64,
    /// By integers of any width.
    pub big_integer: u64,
}

impl StageCounts {
    fn count(&mut self, stage: Stage) {
        *match stage {
            Stage::Filter => &mut self.filter,
            Stage::Integer => &mut self.integer,
            Stage::BigInteger => &mut self.big_integer,
        } += 1;
    }
}

/// The tests of a triangulation by the stages that decided them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct LocalTests {
    /// Orientations, one a triangle.
    pub orient2d: StageCounts,
    /// Circles, one an edge that is tested.
    pub in_circle: StageCounts,
}

/// Repeats the local tests of a triangulation and counts which stages decide; `constrained` are edges that need
/// no test, in any order and direction.
///
/// ```
/// use delone::check;
/// let t = delone::triangulate([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])?;
/// let tests = check::count_stages(t.points(), t.triangles(), &[], &())?;
/// assert_eq!((tests.orient2d.filter, tests.in_circle.filter), (2, 0));
/// assert_eq!(tests.in_circle.integer, 1); // four points on a circle
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::Cancelled`] if the watch says so.
///
/// # Panics
/// If a triangle names no point, or there are more than ids can number.
///
/// *Cost*: that of [`verify`](super::verify()).
pub fn count_stages(
    points: &[Point],
    triangles: &[[VertexId; 3]],
    constrained: &[[VertexId; 2]],
    watch: &dyn Watch,
) -> Result<LocalTests, Error> {
    assert!(triangles.len() <= MOST_TRIANGLES, "too many triangles");
    let steps = (4 + STEPS_PER_TRIANGLE) * triangles.len() as u64;
    let mut pace = Pace::new(watch, Phase::Check, steps);
    let mut tests = LocalTests::default();
    let at = |v: VertexId| points[v.index()];
    for corners in triangles {
        pace.step()?;
        let [a, b, c] = from_smallest(corners.map(at));
        tests.orient2d.count(stage::orient2d(a, b, c).1);
    }
    let mut skipped: Vec<_> = constrained.iter().map(|&ends| ascending(ends)).collect();
    skipped.sort_unstable();
    let adjacency = Adjacency::find(points, triangles, &mut pace, &mut Defects::default())?;
    for h in adjacency.half_edges() {
        pace.step()?;
        let Some(twin) = adjacency.twin(h).filter(|&twin| h < twin) else {
            continue;
        };
        let ends = ascending([adjacency.origin(h), adjacency.dest(h)]);
        if skipped.is_empty() || skipped.binary_search(&ends).is_err() {
            let [a, b, c, d] = quadrilateral(&adjacency, [h, twin]).map(at);
            let corners = match a.lex_cmp(&b).is_lt() {
                true => [a, b, c, d],
                false => [b, a, d, c],
            };
            let [a, b, c, d] = corners;
            tests.in_circle.count(stage::in_circle(a, b, c, d).1);
        }
    }
    pace.finish();
    Ok(tests)
}

/// Returns the ends of an edge, and the vertices to its left and right.
fn quadrilateral(adjacency: &Adjacency, [h, twin]: [HalfEdgeId; 2]) -> [VertexId; 4] {
    let [a, b] = [adjacency.origin(h), adjacency.dest(h)];
    [a, b, adjacency.apex(h), adjacency.apex(twin)]
}

fn ascending([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}

fn from_smallest([a, b, c]: [Point; 3]) -> [Point; 3] {
    if a.lex_cmp(&b).is_lt() && a.lex_cmp(&c).is_lt() {
        [a, b, c]
    } else if b.lex_cmp(&c).is_lt() {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_and_rotation_do_not_count() {
        // Near ties, where filters see only one of two orders.
        let points: Vec<Point> = (0..40)
            .map(|i| (f64::from(i % 7) * 0.1, f64::from(i * i % 11) * 0.3))
            .map(Point::from)
            .collect();
        let t = crate::triangulate(points.iter().copied()).unwrap();
        let count = |triangles: &[[VertexId; 3]]| count_stages(&points, triangles, &[], &());
        let expected = count(t.triangles()).unwrap();
        let mut others = t.triangles().to_vec();
        others.reverse();
        for triangle in others.iter_mut().step_by(2) {
            triangle.rotate_left(1);
        }
        assert_eq!(count(&others).unwrap(), expected);
        assert!(expected.in_circle.integer > 0 && expected.in_circle.filter > 0);
    }

    #[test]
    fn constrained_edges_are_not_tested() {
        let t = crate::triangulate([(0.0, 0.0), (3.0, 0.0), (1.0, 1.0), (0.0, 2.0)]).unwrap();
        let edges: Vec<_> = t.edges().collect();
        let tests = count_stages(t.points(), t.triangles(), &edges, &()).unwrap();
        assert_eq!(tests.in_circle, StageCounts::default());
    }
}
