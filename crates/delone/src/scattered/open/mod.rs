//! The point of Algorithm C (stub).
use super::Cause;
use super::share::{Parts, share};
use crate::predicates::{Orientation, orient2d};
use crate::{Point, VertexId};

pub(super) struct Opening {
    pub at: Point,
    pub shares: Vec<u8>,
}

pub(super) fn open_at(corners: [Point; 3], data: &[Point], least: usize) -> Option<Opening> {
    let [a, b, c] = corners;
    let at = Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0);
    let options: Vec<Parts> = data
        .iter()
        .map(|&p| {
            let s = corners.map(|q| orient2d(at, q, p));
            (0..3)
                .filter(|&k| {
                    s[(k + 1) % 3] != Orientation::Right && s[(k + 2) % 3] != Orientation::Left
                })
                .fold(0, |o, k| o | 1 << k)
        })
        .collect();
    Some(Opening {
        at,
        shares: share(&options, 3, least)?,
    })
}

pub(super) fn conditions(
    _: [Point; 3],
    _: [VertexId; 3],
    _: &[Point],
    _: usize,
) -> Result<(), Cause> {
    Ok(())
}
