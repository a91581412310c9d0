//! Questions about points alone: which are equal, which are missing, do all lie on one line?

use crate::pace::Pace;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point, VertexId};
use std::collections::{HashMap, HashSet};

/// A place as bits, the same for 0.0 and −0.0. Tables are only asked, never listed, so results do
/// not depend on their order.
pub(super) type Place = [u64; 2];

pub(super) fn place(p: Point) -> Place {
    [p.x, p.y].map(|c| (c + 0.0).to_bits())
}

/// Returns the unused points that no used point equals, in order.
///
/// *Cost*: constant if all are used, else linear; memory for the unused ones only.
pub(super) fn find_missing(
    points: &[Point],
    used: &[bool],
    pace: &mut Pace,
) -> Result<Vec<VertexId>, Error> {
    let unused = || vertices(used, false);
    let mut is_covered: HashMap<Place, bool> = HashMap::new();
    for v in unused() {
        pace.step()?;
        is_covered.insert(place(points[v.index()]), false);
    }
    if is_covered.is_empty() {
        return Ok(Vec::new());
    }
    for v in vertices(used, true) {
        pace.step()?;
        if let Some(covered) = is_covered.get_mut(&place(points[v.index()])) {
            *covered = true;
        }
    }
    let missing = unused().filter(|v| !is_covered[&place(points[v.index()])]);
    Ok(missing.collect())
}

/// Returns pairs of used points at the same place, the lower index first.
pub(super) fn find_shared(
    points: &[Point],
    used: &[bool],
    pace: &mut Pace,
) -> Result<Vec<[VertexId; 2]>, Error> {
    let mut first_at: HashMap<Place, VertexId> = HashMap::new();
    let mut shared = Vec::new();
    for v in vertices(used, true) {
        pace.step()?;
        let first = *first_at.entry(place(points[v.index()])).or_insert(v);
        if first != v {
            shared.push([first, v]);
        }
    }
    Ok(shared)
}

/// Counts the places that points occupy.
pub(super) fn count_distinct(points: &[Point], pace: &mut Pace) -> Result<usize, Error> {
    let mut places = HashSet::new();
    for &p in points {
        pace.step()?;
        places.insert(place(p));
    }
    Ok(places.len())
}

/// Returns three points that do not lie on one line, if there are any.
pub(super) fn find_turn(points: &[Point], pace: &mut Pace) -> Result<Option<[VertexId; 3]>, Error> {
    let Some(second) = points.iter().position(|&p| p != points[0]) else {
        return Ok(None);
    };
    for (third, &p) in points.iter().enumerate().skip(second + 1) {
        pace.step()?;
        if orient2d(points[0], points[second], p) != Orientation::Collinear {
            return Ok(Some([0, second, third].map(VertexId::new)));
        }
    }
    Ok(None)
}

/// Visits the vertices that are used, or those that are not.
fn vertices(used: &[bool], wanted: bool) -> impl Iterator<Item = VertexId> + '_ {
    let all = (0..used.len()).filter(move |&v| used[v] == wanted);
    all.map(VertexId::new)
}
