//! Is there a reason for an error? From the definitions.

use super::{Covering, Domain};
use crate::naive::{distinct, naive_largest_least};
use delone::predicates::{Orientation, orient2d};
use delone::{ConstrainedDelaunay, DomainRule, Error, Point, Pslg};

/// Looks into an error.
///
/// # Errors
/// Why nothing entitles to it.
pub(super) fn check(covering: &Covering, error: &Error) -> Result<(), String> {
    let Covering { data, least, .. } = covering;
    let different: Vec<Point> = distinct(data).into_iter().map(|i| data[i]).collect();
    let is_justified = match *error {
        Error::TooFewData {
            distinct,
            least: asked,
        } => distinct == different.len() && asked == *least && distinct < *least,
        Error::CollinearData { distinct } => {
            distinct == different.len() && are_collinear(&different)
        }
        Error::DatumOutside { datum, at } => {
            let corners = covering.corners();
            data[datum] == at && corners.is_some_and(|corners| !contains(&corners, at))
        }
        Error::DomainTooEmpty { .. } => covering.corners().is_some_and(|corners| {
            largest_least(&corners, &different).is_some_and(|largest| largest < *least)
        }),
        // A triangle around the data may be more than three times as far away as they.
        Error::BadChoice { given, .. } => {
            covering.domain == Domain::Free
                && data.iter().any(|p| p.x == given || p.y == given)
                && given.abs() > f64::MAX / 4.0
        }
        // The middle of a box of which one side is as short as can be may lie on its border.
        Error::BadDomain { .. } => covering.domain == Domain::Notch && !is_notched(covering),
        _ => false,
    };
    match is_justified {
        true => Ok(()),
        false => Err(format!("there is no reason for {error:?}")),
    }
}

fn are_collinear(points: &[Point]) -> bool {
    let beside = |&p: &Point| orient2d(points[0], points[1], p) != Orientation::Collinear;
    points.len() < 3 || !points.iter().any(beside)
}

/// Tells whether a point lies in a simple polygon, border included: how often does it wind around it?
fn contains(corners: &[Point], p: Point) -> bool {
    let mut winding = 0;
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % corners.len()];
        let side = orient2d(from, to, p);
        let is_between = |a: f64, b: f64, c: f64| a.min(b) <= c && c <= a.max(b);
        if side == Orientation::Collinear
            && is_between(from.x, to.x, p.x)
            && is_between(from.y, to.y, p.y)
        {
            return true;
        }
        match (from.y <= p.y, to.y <= p.y) {
            (true, false) if side == Orientation::Left => winding += 1,
            (false, true) if side == Orientation::Right => winding -= 1,
            _ => {}
        }
    }
    winding != 0
}

/// Returns how many data each triangle of a polygon alone can hold: with centers there are more triangles, and
/// the first one that is tried has none.
fn largest_least(corners: &[Point], data: &[Point]) -> Option<usize> {
    let mut domain = Pslg::from_points(corners.iter().copied());
    domain.add_ring(0..corners.len() as u32);
    let builder = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    let triangulation = builder.triangulate(domain).ok()?.into_triangulation();
    naive_largest_least(triangulation.points(), triangulation.triangles(), data)
}

/// Tells whether the notch leads into the box.
fn is_notched(covering: &Covering) -> bool {
    let corners = covering.corners().unwrap_or_default();
    let [low, _, high, middle, _] = corners[..] else {
        return false;
    };
    low.x < middle.x && middle.x < high.x && low.y < middle.y && middle.y < high.y
}
