//! Algorithm C (chapter 3.43): vertices in triangles that hold 3d data or more.
//!
//! The text begins with the fullest triangle again after each vertex, and so looks at triangles that cannot be opened
//! again and again. Whether one can depends on it and its data alone: so here it is looked at again only when they have
//! changed, with the same result.

use super::algorithm_b::divide_at;
use super::field::Field;
use super::open::{conditions, open_at, open_stepwise};
use super::{Cause, Cover, Exception};
use crate::{Error, Event, Observer, Point, Stage, TriangleId};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// Its pseudocode.
pub(crate) const CODE_C: &[&str] = &[
    "order the triangles by the data that they hold, the fullest first; j := 1",
    "while the j-th triangle holds at least 3d data:",
    "  if too many of them lie on one or two of its edges: j := j + 1",
    "  else: find a point t in it that leaves each of the three parts at least d data",
    "    join t to its corners",
    "    flip edges around t, where that makes angles larger and leaves d data on both sides",
    "    order the triangles anew; j := 1",
];

/// Runs it, and returns which triangles hold more than 3d − 1 data, ascending, and why.
///
/// # Errors
/// [`Error::TooManyPoints`], [`Error::Cancelled`].
pub(super) fn run(
    field: &mut Field<impl Observer>,
    options: &Cover,
) -> Result<Vec<Exception>, Error> {
    let least = options.least;
    let mut full = Full::default();
    field.at(1);
    let all: Vec<_> = field.draft.mesh.triangles().collect();
    all.into_iter().for_each(|t| field.stock.touch(t));
    full.update(field, least);
    while let Some(t) = full.next() {
        field.at(2);
        let triangle = field.names(t);
        field.tell(|| Event::TriangleConsidered { triangle });
        if divide(field, t, options)? || divide_edge(field, t, options)? || relieve(field, t, least)
        {
            full.update(field, least);
        } else {
            field.at(3);
            field.tell(|| Event::DivisionFailed { triangle });
            full.set_aside(t);
        }
    }
    field.tell(|| Event::StageEnded {
        stage: Stage::DivideTriangles,
        min_angle: None,
    });
    Ok(full
        .aside
        .iter()
        .map(|(&t, _)| exception(field, t, least))
        .collect())
}

/// Puts a vertex into a triangle, if there is a place that leaves all three parts enough.
fn divide(field: &mut Field<impl Observer>, t: TriangleId, options: &Cover) -> Result<bool, Error> {
    let least = options.least;
    let data: Vec<Point> = field.data_of(t).collect();
    field.spend(8 * data.len())?;
    let corners = field.corners(t);
    field.at(4);
    let found = match options.is_stepwise {
        true => open_stepwise(corners, &data, least, |at, counts| {
            let [a, b, c] = counts.map(|count| count as u32);
            let counts = [a, b, c, 0];
            field.tell(|| Event::PlaceTried { at, counts });
        }),
        false => open_at(corners, &data, least),
    };
    let Some(opening) = found else {
        return Ok(false);
    };
    field.at(5);
    let v = field.divide_triangle(t, opening.at, &opening.shares)?;
    field.advance()?;
    if options.optimizes {
        field.at(6);
        field.optimize(v, least)?;
    }
    Ok(true)
}

/// Divides an edge of a triangle on which so many data lie that both halves have enough of them (3.41).
fn divide_edge(
    field: &mut Field<impl Observer>,
    t: TriangleId,
    options: &Cover,
) -> Result<bool, Error> {
    for h in t.half_edges() {
        if divide_at(field, h, options)? {
            field.advance()?;
            return Ok(true);
        }
    }
    Ok(false)
}

/// Lets neighbours have data on the boundary of a triangle, if that helps.
fn relieve(field: &mut Field<impl Observer>, t: TriangleId, least: usize) -> bool {
    let before = field.stock.count(t);
    field.lower(t, 3 * least - 1);
    field.stock.count(t) < before
}

/// Lists the triangles that hold more than 3d − 1 data, ascending, for whoever does not run it.
pub(super) fn untried(field: &Field<impl Observer>, least: usize) -> Vec<Exception> {
    let triangles = field.draft.mesh.triangles();
    let named = triangles.map(|triangle| Exception {
        triangle,
        data: field.stock.count(triangle),
        cause: Cause::Untried,
    });
    named
        .filter(|exception| exception.data >= 3 * least)
        .collect()
}

fn exception(field: &Field<impl Observer>, t: TriangleId, least: usize) -> Exception {
    let data: Vec<Point> = field.data_of(t).collect();
    let corners = field.draft.mesh.corners(t);
    let cause = match conditions(field.corners(t), corners, &data, least) {
        Ok(()) => Cause::Resolution,
        Err(cause) => cause,
    };
    Exception {
        triangle: t,
        data: data.len(),
        cause,
    }
}

/// Triangles that hold 3d data or more, the fullest first, and those among them that cannot be opened as they are.
#[derive(Default)]
struct Full {
    open: BTreeSet<(Reverse<usize>, TriangleId)>,
    counts: BTreeMap<TriangleId, usize>,
    aside: BTreeMap<TriangleId, usize>,
}

impl Full {
    /// Takes note of all triangles that have changed.
    fn update(&mut self, field: &mut Field<impl Observer>, least: usize) {
        let touched: BTreeSet<_> = field.stock.drain_touched().collect();
        for t in touched {
            if let Some(count) = self.counts.remove(&t) {
                self.open.remove(&(Reverse(count), t));
            }
            self.aside.remove(&t);
            if t.index() >= field.draft.mesh.num_faces() {
                continue;
            }
            let count = field.stock.count(t);
            if count >= 3 * least {
                self.counts.insert(t, count);
                self.open.insert((Reverse(count), t));
            }
        }
    }

    fn next(&self) -> Option<TriangleId> {
        self.open.first().map(|&(_, t)| t)
    }

    fn set_aside(&mut self, t: TriangleId) {
        let count = self
            .counts
            .remove(&t)
            .expect("bug: it is not among the full ones");
        self.open.remove(&(Reverse(count), t));
        self.aside.insert(t, count);
    }
}
