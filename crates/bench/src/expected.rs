//! How many triangles and constrained edges a result must have, found without triangulating.
//!
//! Euler: v distinct points of which h lie on the boundary of the convex hull (those inside its
//! edges included) have 2v − 2 − h triangles, constrained or not; inside a ring of n vertices there
//! are n − 2. The hull comes from Andrew's monotone chain with the adaptive exact `orient2d` of the
//! `robust` crate, so this shares no code with any builder of ours. The count does not prove a triangulation Delaunay; a wrong count proves it broken.
//!
//! *Cost*: O(n log n), about 150 ns a point at a million.

use crate::engines::{Engine, Extent};
use crate::subject::{Subject, Task};
use delone_samples::Drawing;
use robust::{Coord, orient2d};
use serde::{Deserialize, Serialize};

/// What a result must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Expected {
    /// So many triangles.
    pub triangles: usize,
    /// So many constrained edges, if the engine counts them: clean segments become an edge each.
    pub constrained: usize,
}

impl Expected {
    /// Returns what `engine` must make of `subject`, which was drawn as `drawing`. Of crossing
    /// segments nothing is known in advance.
    pub fn of(engine: Engine, subject: Subject, drawing: &Drawing) -> Option<Self> {
        let extent = engine.facts(subject.task())?.extent;
        let triangles = match (subject.task(), extent) {
            (Task::Crossings, _) => return None,
            (Task::Domain, Extent::InsideRings | Extent::OnlyRings) if subject.is_ring() => {
                drawing.points.len().saturating_sub(2)
            }
            _ => num_triangles(&drawing.points),
        };
        Some(Self {
            triangles,
            constrained: drawing.segments.len(),
        })
    }
}

/// Counts the triangles of any triangulation of the distinct points among `points`.
pub fn num_triangles(points: &[[f64; 2]]) -> usize {
    let sorted = distinct_sorted(points);
    if sorted.len() < 2 {
        return 0;
    }
    let lower = chain_len(sorted.iter());
    let upper = chain_len(sorted.iter().rev());
    // The two ends belong to both chains. Collinear points are all on both: 0 triangles.
    2 * sorted.len() - 2 - (lower + upper - 2)
}

fn distinct_sorted(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted: Vec<_> = points.iter().map(|p| p.map(|c| c + 0.0)).collect();
    sorted.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    sorted
}

/// Counts the points of the hull's chain to the right of the way through `sorted`.
fn chain_len<'p>(sorted: impl Iterator<Item = &'p [f64; 2]>) -> usize {
    let mut chain: Vec<Coord<f64>> = Vec::new();
    for &[x, y] in sorted {
        let next = Coord { x, y };
        while let [.., a, b] = chain[..]
            && orient2d(a, b, next) < 0.0
        {
            chain.pop();
        }
        chain.push(next);
    }
    chain.len()
}

#[cfg(test)]
mod tests {
    use super::{Expected, num_triangles};
    use crate::engines::Engine;
    use delone_samples::{Distribution, Domain};

    #[test]
    fn rings_count_inside_or_hull() {
        let ring = Domain::Spiral.draw(100, 1);
        let of = |engine, subject| Expected::of(engine, subject, &ring);
        let inside = of(Engine::Cdt, Domain::Spiral.into()).unwrap();
        assert_eq!((inside.triangles, inside.constrained), (98, 100));
        let hull = of(Engine::Spade, Domain::Spiral.into()).unwrap();
        assert_eq!(hull.triangles, num_triangles(&ring.points));
        assert!(hull.triangles > 98);
        assert_eq!(of(Engine::Spade, Domain::Tangle.into()), None);
        assert_eq!(of(Engine::ITriangle, Distribution::Grid.into()), None);
    }

    #[test]
    fn small_sets() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        assert_eq!(num_triangles(&[]), 0);
        assert_eq!(num_triangles(&square[..1]), 0);
        assert_eq!(num_triangles(&square[..2]), 0);
        assert_eq!(num_triangles(&square[..3]), 1);
        assert_eq!(num_triangles(&square), 2);
        assert_eq!(num_triangles(&[square[0]; 5]), 0);
    }

    #[test]
    fn collinear_points_have_none() {
        let diagonal: Vec<_> = (0..50).map(|i| [f64::from(i); 2]).collect();
        let vertical: Vec<_> = (0..50).map(|i| [3.0, f64::from(i)]).collect();
        assert_eq!(num_triangles(&diagonal), 0);
        assert_eq!(num_triangles(&vertical), 0);
    }

    #[test]
    fn lattice_counts_points_inside_hull_edges_and_duplicates_once() {
        let lattice: Vec<_> = (0..2 * 12 * 7)
            .map(|i| [f64::from(i % 12), f64::from(i / 12 % 7)])
            .collect();
        assert_eq!(num_triangles(&lattice), 2 * 11 * 6);
    }
}
