//! How many triangles a point set must have, found without triangulating it.
//!
//! Euler: v distinct points of which h lie on the boundary of the convex hull (those inside its
//! edges included) have 2v − 2 − h triangles. The hull comes from Andrew's monotone chain with the
//! adaptive exact `orient2d` of the `robust` crate, so this shares no code with any builder of
//! ours. The count does not prove a triangulation Delaunay; a wrong count proves it broken.
//!
//! *Cost*: O(n log n), about 150 ns a point at a million.

use robust::{Coord, orient2d};

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
    use super::num_triangles;

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
