//! The definitions, word for word: nothing here knows a triangulation.

use delone::predicates::{CircleSide, compare_distances, compare_lengths, in_diametral_circle};
use delone::{Point, VertexId};
use delone_testkit::naive::distinct;

pub type Edge = [VertexId; 2];

/// All pairs of distinct points, lower index first.
pub fn pairs(points: &[Point]) -> Vec<[usize; 2]> {
    let vertices = distinct(points);
    let pairs = vertices.iter().flat_map(|&a| {
        let above = vertices.iter().filter(move |&&b| a < b);
        above.map(move |&b| [a, b])
    });
    pairs.collect()
}

/// All pairs that are not excluded by some other point.
fn pairs_without(points: &[Point], excludes: impl Fn(Point, Point, Point) -> bool) -> Vec<Edge> {
    let is_free = |&[a, b]: &[usize; 2]| {
        let others = points.iter().filter(|&&c| c != points[a] && c != points[b]);
        !others
            .into_iter()
            .any(|&c| excludes(points[a], points[b], c))
    };
    let free = pairs(points).into_iter().filter(is_free);
    free.map(|e| e.map(VertexId::new)).collect()
}

pub fn gabriel_graph(points: &[Point]) -> Vec<Edge> {
    pairs_without(points, |a, b, c| {
        in_diametral_circle(a, b, c) != CircleSide::Outside
    })
}

pub fn relative_neighborhood_graph(points: &[Point]) -> Vec<Edge> {
    pairs_without(points, |a, b, c| {
        compare_distances(a, c, b).is_lt() && compare_distances(b, c, a).is_lt()
    })
}

/// All pairs, shortest first, then by index.
pub fn sorted_pairs(points: &[Point]) -> Vec<[usize; 2]> {
    let mut pairs = pairs(points);
    pairs.sort_by(|&s, &t| {
        let ends = |e: [usize; 2]| e.map(|v| points[v]);
        compare_lengths(ends(s), ends(t)).then(s.cmp(&t))
    });
    pairs
}

/// Kruskal on all pairs, with labels.
pub fn spanning_tree(points: &[Point]) -> Vec<Edge> {
    let mut label: Vec<usize> = (0..points.len()).collect();
    let mut tree = Vec::new();
    for [a, b] in sorted_pairs(points) {
        let [from, to] = [label[a], label[b]];
        if from != to {
            label
                .iter_mut()
                .filter(|l| **l == from)
                .for_each(|l| *l = to);
            tree.push([a, b].map(VertexId::new));
        }
    }
    tree
}

pub fn nearest_neighbors(points: &[Point]) -> Vec<Option<VertexId>> {
    let vertices = distinct(points);
    let nearest = |v: usize| {
        let others = vertices.iter().filter(|&&w| w != v);
        let nearest = others.min_by(|&&a, &&b| compare_distances(points[v], points[a], points[b]));
        nearest.map(|&w| VertexId::new(w))
    };
    let is_vertex = |v: &usize| vertices.contains(v);
    (0..points.len())
        .map(|v| Some(v).filter(is_vertex).and_then(nearest))
        .collect()
}
