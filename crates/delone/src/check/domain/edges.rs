//! Which edges the graph has: the claimed subsegments and, under [`DomainRule::Hull`], the hull.
//!
//! Of a refined mesh the hull is made of segments like any other, which are split and rounded: there
//! the edges of the input's hull are segments, and the graph has subsegments only.

use super::super::{Corner, Defect, Defects};
use super::graph::Edge;
use super::places::{Place, Places};
use super::sort::sort;
use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point, VertexId};

/// Most edges whose darts 32 bits can number.
const MOST_EDGES: usize = u32::MAX as usize / 2;

/// Reports subsegments that have no two ends, and too many of them.
pub(super) fn check_ends(
    points: &[Point],
    subsegments: &[[VertexId; 2]],
    pace: &mut Pace,
    defects: &mut Defects,
) -> Result<(), Error> {
    // The hull has as many edges as there are points, at most.
    let limit = MOST_EDGES.saturating_sub(points.len());
    if subsegments.len() > limit {
        let given = subsegments.len();
        defects.push(Defect::TooManySubsegments { given, limit });
        return Ok(());
    }
    for (subsegment, ends) in subsegments.iter().enumerate() {
        pace.step()?;
        if let Some(&vertex) = ends.iter().find(|v| v.index() >= points.len()) {
            defects.push(Defect::SubsegmentOutOfRange {
                subsegment,
                vertex,
                points: points.len(),
            });
        } else if points[ends[0].index()] == points[ends[1].index()] {
            let ends = ends.map(|v| Corner::new(points, v));
            defects.push(Defect::EmptySubsegment { subsegment, ends });
        }
    }
    Ok(())
}

/// Lists the edges of the graph, sorted and each once, with those of the hull if it is asked for; reports
/// subsegments that repeat.
pub(super) fn collect(
    places: &Places,
    subsegments: &[[VertexId; 2]],
    with_hull: bool,
    pace: &mut Pace,
) -> Result<(Vec<Edge>, Vec<[Place; 2]>), Error> {
    let mut edges = Vec::with_capacity(subsegments.len());
    for ends in subsegments {
        pace.step()?;
        let [a, b] = ends.map(|v| places.of(v));
        edges.push(Edge {
            ends: [a.min(b), a.max(b)],
            is_subsegment: true,
        });
    }
    if with_hull {
        edges.extend(hull(places, pace)?);
    }
    // Of equal edges the subsegment comes first, and stays.
    sort(&mut edges, pace, |a, b| {
        a.ends
            .cmp(&b.ends)
            .then(b.is_subsegment.cmp(&a.is_subsegment))
    })?;
    let both = |pair: &[Edge]| pair[0].ends == pair[1].ends && pair[1].is_subsegment;
    let repeated = edges.windows(2).filter(|pair| both(pair));
    let repeated = repeated.map(|pair| pair[0].ends).collect();
    edges.dedup_by_key(|edge| edge.ends);
    Ok((edges, repeated))
}

/// Lists the edges of the convex hull, from each place on it to the next; on one line, all twice.
fn hull(places: &Places, pace: &mut Pace) -> Result<Vec<Edge>, Error> {
    let lower = chain(places, places.all(), Orientation::Right, pace)?;
    let upper = chain(places, places.all(), Orientation::Left, pace)?;
    let steps = lower.windows(2).chain(upper.windows(2));
    let edges = steps.map(|step| Edge {
        ends: [step[0], step[1]],
        is_subsegment: false,
    });
    Ok(edges.collect())
}

/// Lists the edges of the convex hull of the first `num_points` points as segments: counter-clockwise
/// from the leftmost one; none if all lie on one line.
pub(super) fn hull_segments(
    places: &Places,
    num_points: usize,
    pace: &mut Pace,
) -> Result<Vec<[VertexId; 2]>, Error> {
    // Added points are at places of their own.
    let is_given = |&place: &Place| places.vertex(place).index() < num_points;
    let given: Vec<Place> = places.all().filter(is_given).collect();
    let lower = chain(places, given.iter().copied(), Orientation::Right, pace)?;
    let mut upper = chain(places, given.iter().copied(), Orientation::Left, pace)?;
    if lower == upper {
        return Ok(Vec::new());
    }
    upper.reverse();
    let steps = lower.windows(2).chain(upper.windows(2));
    Ok(steps
        .map(|step| [step[0], step[1]].map(|place| places.vertex(place)))
        .collect())
}

/// Returns the chain from the first of some places to the last that never turns to the side `forbidden`.
fn chain(
    places: &Places,
    ascending: impl Iterator<Item = Place>,
    forbidden: Orientation,
    pace: &mut Pace,
) -> Result<Vec<Place>, Error> {
    let mut chain: Vec<Place> = Vec::new();
    for place in ascending {
        pace.step()?;
        while let [.., a, b] = chain[..] {
            let [a, b, c] = [a, b, place].map(|p| places.at(p));
            if orient2d(a, b, c) != forbidden {
                break;
            }
            pace.step()?;
            chain.pop();
        }
        chain.push(place);
    }
    Ok(chain)
}
