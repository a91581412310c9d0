//! Closest pair, nearest neighbours, spanning tree, clusters, Gabriel and relative neighbourhood graph.

use crate::{naive, on_small_sets, triangulated};
use delone::predicates::length_up;
use delone::proximity::Proximity;
use delone::{Error, Point, VertexId};
use delone_testkit::generate::Kind;
use proptest::prelude::*;

fn assert_graphs(points: &[Point], proximity: &Proximity) {
    let tree = proximity.spanning_tree().unwrap();
    assert_eq!(tree.edges(), naive::spanning_tree(points));
    let closest = naive::sorted_pairs(points)
        .first()
        .map(|e| e.map(VertexId::new));
    assert_eq!(proximity.closest_pair().unwrap(), closest);
    let nearest = proximity.nearest_neighbors().unwrap();
    assert_eq!(nearest, naive::nearest_neighbors(points));
    let gabriel = proximity.gabriel_graph().unwrap();
    assert_eq!(gabriel, naive::gabriel_graph(points));
    let relative = proximity.relative_neighborhood_graph().unwrap();
    assert_eq!(relative, naive::relative_neighborhood_graph(points));
    // Each lies in the next one.
    assert!(relative.iter().all(|e| gabriel.contains(e)));
    assert!(tree.edges().iter().all(|e| relative.contains(e)));
}

#[test]
fn graphs_are_as_defined() {
    on_small_sets(40, assert_graphs);
}

proptest! {
    #[test]
    fn graphs_of_tiny_lattices(points in prop::collection::vec((0..5_i8, 0..4_i8), 0..14)) {
        let points: Vec<Point> = points.into_iter().map(|(x, y)| Point::new(x.into(), y.into())).collect();
        let t = triangulated(&points);
        assert_graphs(&points, &Proximity::new(&t, &()).unwrap());
    }
}

/// Every number of points of a lattice of 700 × 50: runs of equal lengths longer than one piece.
#[test]
fn long_runs_of_equal_lengths_are_sorted() {
    let points: Vec<Point> = (0..35_000)
        .map(|i| Point::new(f64::from(i * 7 % 700), f64::from(i / 700)))
        .collect();
    let t = triangulated(&points);
    let proximity = Proximity::new(&t, &()).unwrap();
    let tree = proximity.spanning_tree().unwrap();
    assert!(tree.edges().is_sorted_by(|a, b| {
        let length = |e: &[VertexId; 2]| length_up(e.map(|v| t.point(v)));
        length(a) < length(b) || (length(a) == length(b) && a < b)
    }));
    assert_eq!(tree.edges().len(), t.num_vertices() - 1);
}

/// Far clusters: the floods of the relative neighbourhood graph run through whole clusters.
#[test]
fn relative_neighbors_across_clusters() {
    for seed in 0..5 {
        let points = Kind::Clusters.points(150, seed);
        let t = triangulated(&points);
        let found = Proximity::new(&t, &())
            .unwrap()
            .relative_neighborhood_graph();
        assert_eq!(found.unwrap(), naive::relative_neighborhood_graph(&points));
    }
}

/// Groups by the definition: whoever is within the distance of one belongs to the group.
fn naive_clusters(points: &[Point], distance: f64) -> Vec<usize> {
    let mut group: Vec<usize> = (0..points.len()).collect();
    for (a, b) in (0..points.len()).flat_map(|a| (0..a).map(move |b| (a, b))) {
        if length_up([points[a], points[b]]) <= distance {
            let [from, to] = [group[a], group[b]];
            group
                .iter_mut()
                .filter(|g| **g == from)
                .for_each(|g| *g = to);
        }
    }
    let mut names = Vec::new();
    group
        .iter()
        .map(|g| {
            names.iter().position(|name| name == g).unwrap_or_else(|| {
                names.push(*g);
                names.len() - 1
            })
        })
        .collect()
}

#[test]
fn clusters_are_single_linkage() {
    on_small_sets(30, |points, proximity| {
        let tree = proximity.spanning_tree().unwrap();
        let mut distances = tree.lengths().to_vec();
        distances.extend(tree.lengths().iter().map(|l| l.next_down()));
        distances.push(0.0);
        for distance in distances {
            let clusters = tree.clusters_within(distance).unwrap();
            assert_eq!(clusters.of, naive_clusters(points, distance), "{distance}");
            assert_eq!(
                clusters.count,
                clusters.of.iter().max().map_or(0, |m| m + 1)
            );
            assert_eq!(tree.clusters(clusters.count), clusters);
        }
        let vertices = proximity.triangulation().num_vertices();
        assert_eq!(tree.clusters(0).count, vertices.min(1));
        assert_eq!(tree.clusters(usize::MAX).count, vertices);
    });
}

#[test]
fn distances_must_be_numbers() {
    let t = triangulated(&[]);
    let proximity = Proximity::new(&t, &()).unwrap();
    let tree = proximity.spanning_tree().unwrap();
    for bad in [-1.0, f64::NAN, f64::NEG_INFINITY] {
        assert!(matches!(
            tree.clusters_within(bad),
            Err(Error::BadRadius { .. })
        ));
        let shape = proximity.alpha_shapes().unwrap().shape(bad);
        assert!(matches!(shape, Err(Error::BadRadius { .. })));
    }
    assert_eq!(tree.clusters_within(f64::INFINITY).unwrap().count, 0);
    assert_eq!(tree.length(), 0.0);
}
