//! The naive judge: what a cover is, by definition, every triangle against every other.

use super::cover::Cover;
use delone::predicates::{Orientation, orient2d};
use delone::{Point, VertexId};
use delone_testkit::naive::triangles_at;
use std::collections::{BTreeMap, BTreeSet};

/// Tells whether a cover, whose corners are points and whose holders are triangles, is right.
pub fn is_right(cover: &Cover) -> bool {
    are_side_by_side(cover) && is_disc(cover) && are_data_right(cover)
}

fn corners(cover: &Cover, t: &[VertexId; 3]) -> [Point; 3] {
    t.map(|v| cover.points[v.index()])
}

fn sides<T: Copy>([a, b, c]: [T; 3]) -> [[T; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Upright triangles whose interiors are disjoint, and no vertex in a triangle but its own corners.
fn are_side_by_side(cover: &Cover) -> bool {
    let all: Vec<[Point; 3]> = cover.triangles.iter().map(|t| corners(cover, t)).collect();
    let is_upright = |&[a, b, c]: &[Point; 3]| orient2d(a, b, c) == Orientation::Left;
    // Convex sets are disjoint if and only if a line along an edge separates them.
    let separates = |t: &[Point; 3], u: &[Point; 3]| {
        sides(*t)
            .iter()
            .any(|&[a, b]| u.iter().all(|&p| orient2d(a, b, p) != Orientation::Left))
    };
    let are_disjoint =
        |i: usize, j: usize| separates(&all[i], &all[j]) || separates(&all[j], &all[i]);
    all.iter().all(is_upright)
        && (0..all.len()).all(|i| (0..i).all(|j| are_disjoint(i, j)))
        && (0..cover.points.len()).all(|v| {
            let at = triangles_at(&cover.points, &cover.triangles, cover.points[v]);
            let has = |t: &usize| cover.triangles[*t].contains(&VertexId::new(v));
            !at.is_empty() && at.iter().all(has)
        })
}

/// Connected across edges, around each vertex too, and with Euler's number of a disc.
fn is_disc(cover: &Cover) -> bool {
    let triangles = &cover.triangles;
    let mut at_edge: BTreeMap<[VertexId; 2], Vec<usize>> = BTreeMap::new();
    for (t, &triangle) in triangles.iter().enumerate() {
        for [a, b] in sides(triangle) {
            at_edge.entry([a.min(b), a.max(b)]).or_default().push(t);
        }
    }
    let is_connected = |among: &dyn Fn(usize) -> bool, across: &dyn Fn(&[VertexId; 2]) -> bool| {
        let all: BTreeSet<usize> = (0..triangles.len()).filter(|&t| among(t)).collect();
        let mut reached: BTreeSet<usize> = all.iter().copied().take(1).collect();
        loop {
            let edges = at_edge.iter().filter(|(edge, _)| across(edge));
            let near = edges.filter(|(_, at)| at.iter().any(|t| reached.contains(t)));
            let more: BTreeSet<usize> = near.flat_map(|(_, at)| at.iter().copied()).collect();
            let before = reached.len();
            reached.extend(more.intersection(&all));
            if reached.len() == before {
                return reached == all;
            }
        }
    };
    let euler = cover.points.len() + triangles.len() == at_edge.len() + 1;
    !triangles.is_empty()
        && euler
        && is_connected(&|_| true, &|_| true)
        && (0..cover.points.len())
            .map(VertexId::new)
            .all(|v| is_connected(&|t| triangles[t].contains(&v), &|edge| edge.contains(&v)))
}

/// Data lie in their holders, equal ones in the same, and there are enough.
fn are_data_right(cover: &Cover) -> bool {
    let mut held = vec![0; cover.triangles.len()];
    for (datum, holder) in cover.holders.iter().enumerate() {
        let at = cover.data[datum];
        let first = cover.data.iter().position(|&p| p == at).expect("itself");
        let lies_in = triangles_at(&cover.points, &cover.triangles, at);
        if cover.holders[first] != *holder || !lies_in.contains(&holder.index()) {
            return false;
        }
        held[holder.index()] += usize::from(first == datum);
    }
    held.iter().all(|&held| held >= cover.least)
}
