//! Alpha shapes against their definition, at every critical radius and just below.

use crate::{naive, on_small_sets};
use delone::predicates::{circumradius_up, length_up};
use delone::proximity::{AlphaShape, AlphaShapes, Proximity};
use delone::{Point, VertexId};
use delone_testkit::naive::{distinct, naive_delaunay};
use std::collections::BTreeSet;

type Edge = naive::Edge;

fn undirected([a, b]: Edge) -> Edge {
    if a < b { [a, b] } else { [b, a] }
}

fn sides([a, b, c]: [VertexId; 3]) -> [Edge; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Half of a length is at most a radius if the length is at most twice that.
fn fits(points: &[Point], [a, b]: Edge, alpha: f64) -> bool {
    length_up([points[a.index()], points[b.index()]]) <= 2.0 * alpha
}

/// Compares a shape with all triangles and pairs that belong to it.
fn assert_shape(points: &[Point], proximity: &Proximity, shape: &AlphaShape, alpha: f64) {
    let triangles: Vec<_> = naive_delaunay(points)
        .into_iter()
        .filter(|t| {
            let [a, b, c] = t.map(|v| points[v.index()]);
            circumradius_up(a, b, c) <= alpha
        })
        .collect();
    let corners = |t: &delone::TriangleId| {
        let mut corners = proximity.triangulation().mesh().corners(*t);
        while corners[0] > corners[1] || corners[0] > corners[2] {
            corners.rotate_left(1);
        }
        corners
    };
    let mut found: Vec<_> = shape.triangles.iter().map(corners).collect();
    found.sort();
    assert_eq!(found, triangles, "{alpha}");

    let directed: BTreeSet<Edge> = triangles.iter().flat_map(|&t| sides(t)).collect();
    let is_border = |[a, b]: &Edge| !directed.contains(&[*b, *a]);
    let border: BTreeSet<Edge> = directed.iter().copied().filter(is_border).collect();
    let along = |ring: &Vec<VertexId>| {
        let n = ring.len();
        (0..n)
            .map(|i| [ring[i], ring[(i + 1) % n]])
            .collect::<Vec<_>>()
    };
    let rings: Vec<Edge> = shape.boundary.iter().flat_map(along).collect();
    assert_eq!(rings.len(), border.len(), "an edge twice");
    assert_eq!(rings.into_iter().collect::<BTreeSet<_>>(), border);

    let of_triangles: BTreeSet<Edge> = directed.into_iter().map(undirected).collect();
    let gabriel = naive::gabriel_graph(points);
    let singular = gabriel
        .into_iter()
        .filter(|e| fits(points, *e, alpha) && !of_triangles.contains(e));
    let singular: Vec<Edge> = singular.collect();
    assert_eq!(shape.singular_edges, singular, "{alpha}");

    let edges = of_triangles.iter().chain(&singular);
    let touched: BTreeSet<VertexId> = edges.flatten().copied().collect();
    let alone = distinct(points).into_iter().map(VertexId::new);
    let alone: Vec<_> = alone.filter(|v| !touched.contains(v)).collect();
    assert_eq!(shape.singular_vertices, alone, "{alpha}");
}

/// Doubling a radius must not round.
fn is_normal(alpha: f64) -> bool {
    alpha == 0.0 || (f64::MIN_POSITIVE..f64::MAX / 2.0).contains(&alpha)
}

#[test]
fn shapes_are_as_defined() {
    on_small_sets(16, |points, proximity| {
        let shapes = proximity.alpha_shapes().unwrap();
        let radii = shapes.critical_radii();
        assert!(radii.is_sorted_by(|a, b| a < b));
        let mut before = shapes.shape(0.0).unwrap();
        for &radius in &radii {
            for alpha in [radius.next_down(), radius] {
                if is_normal(alpha) {
                    let shape = shapes.shape(alpha).unwrap();
                    assert_shape(points, proximity, &shape, alpha);
                }
            }
            // Critical radii are where something changes, and only they.
            let [below, at] = [radius.next_down(), radius].map(|r| shapes.shape(r).unwrap());
            assert_eq!(below, before);
            assert_ne!(below, at);
            before = at;
        }
        let all = shapes.shape(f64::INFINITY).unwrap();
        assert_eq!(
            all.triangles.len(),
            proximity.triangulation().num_triangles()
        );
        assert_helpers(&shapes, &radii);
    });
}

/// Groups of triangles that share edges, counted by labels.
fn pieces(proximity: &Proximity, shape: &AlphaShape) -> usize {
    let t = proximity.triangulation();
    let mut left: BTreeSet<_> = shape.triangles.iter().copied().collect();
    let mut count = 0;
    while let Some(first) = left.pop_first() {
        count += 1;
        let mut waiting = vec![first];
        while let Some(face) = waiting.pop() {
            let neighbors = t.neighbors(face).into_iter().flatten();
            waiting.extend(neighbors.filter(|n| left.remove(n)));
        }
    }
    count
}

fn is_connected(proximity: &Proximity, shape: &AlphaShape) -> bool {
    let t = proximity.triangulation();
    let triangles = shape
        .triangles
        .iter()
        .flat_map(|&f| sides(t.mesh().corners(f)));
    let edges: Vec<Edge> = triangles
        .chain(shape.singular_edges.iter().copied())
        .collect();
    let mut label: Vec<usize> = (0..t.points().len()).collect();
    for [a, b] in edges {
        let [from, to] = [label[a.index()], label[b.index()]];
        label
            .iter_mut()
            .filter(|l| **l == from)
            .for_each(|l| *l = to);
    }
    let labels: BTreeSet<usize> = distinct(t.points()).into_iter().map(|v| label[v]).collect();
    labels.len() <= 1
}

fn assert_helpers(shapes: &AlphaShapes, radii: &[f64]) {
    let proximity = shapes.proximity();
    let candidates = || [0.0].into_iter().chain(radii.iter().copied());
    let connecting = candidates().find(|&r| is_connected(proximity, &shapes.shape(r).unwrap()));
    assert_eq!(
        shapes.connecting_radius().unwrap(),
        connecting.expect("at infinity")
    );
    let vertices = proximity.triangulation().num_vertices();
    let is_solid = |r: f64| {
        let shape = shapes.shape(r).unwrap();
        let corners = shape
            .triangles
            .iter()
            .flat_map(|&t| proximity.triangulation().mesh().corners(t));
        let corners: BTreeSet<VertexId> = corners.collect();
        corners.len() == vertices && pieces(proximity, &shape) == 1
    };
    assert_eq!(
        shapes.solid_radius().unwrap(),
        candidates().find(|&r| is_solid(r))
    );
}
