//! Deals data out among triangles.

use super::Field;
use super::around::MANY;
use crate::predicates::{Orientation, orient2d};
use crate::scattered::stock::Held;
use crate::{Error, HalfEdgeId, Observer, Point, TriangleId};

impl<O: Observer> Field<'_, O> {
    /// Gives each of `held` to one of `faces` that contains it; there must be one. `faces` is ascending, and
    /// their lists are empty.
    ///
    /// *Cost*: a few orientation tests for each datum, as each is likely to lie where the one before it does.
    pub fn deal(&mut self, held: &[Held], faces: &[TriangleId]) -> Result<(), Error> {
        let corners: Vec<_> = faces.iter().map(|&t| self.corners(t)).collect();
        let mut place = 0;
        for &held in held {
            let p = self.data.points[held.datum()];
            if faces.len() >= MANY && contains(&corners[place], p).is_none() {
                // Likely near by; if the walk leads elsewhere, all are looked at.
                let there = self.find(p, faces[place])?;
                place = there
                    .and_then(|t| faces.binary_search(&t).ok())
                    .unwrap_or(place);
            }
            let others = || (0..faces.len()).filter(|&other| other != place);
            let mut places = std::iter::once(place).chain(others());
            let found = places.find_map(|k| Some((k, contains(&corners[k], p)?)));
            let (k, is_on_border) =
                found.expect("bug: the triangles do not cover what they replace");
            self.stock
                .give(faces[k], Held::new(held.datum(), is_on_border));
            place = k;
        }
        for &t in faces {
            self.stock.touch(t);
        }
        self.spend(4 * held.len())
    }

    /// Deals out all data among all triangles.
    pub(super) fn deal_all(&mut self) -> Result<(), Error> {
        let Some(mut t) = self.draft.mesh.triangles().next() else {
            return match self.data.names.first() {
                Some(&datum) => Err(self.outside(datum.index())),
                None => Ok(()),
            };
        };
        for datum in 0..self.data.points.len() {
            let p = self.data.points[datum];
            t = self
                .find(p, t)?
                .ok_or_else(|| self.outside(self.data.names[datum].index()))?;
            let is_on_border = contains(&self.corners(t), p).expect("bug: it was found there");
            self.stock.give(t, Held::new(datum, is_on_border));
            self.spend(4)?;
        }
        let all: Vec<_> = self.draft.mesh.triangles().collect();
        all.into_iter().for_each(|t| self.stock.touch(t));
        Ok(())
    }

    fn outside(&self, datum: usize) -> Error {
        let at = self.data.given[datum];
        Error::DatumOutside { datum, at }
    }

    /// Finds a triangle that contains `p`: walks from triangle `t`, and looks at all if that does not lead there,
    /// as it may not where the outline is not convex.
    pub fn find(&mut self, p: Point, t: TriangleId) -> Result<Option<TriangleId>, Error> {
        /// Triangles that a walk may take.
        const PATIENCE: usize = 1 << 10;
        let mut at = t;
        let mut entered: Option<HalfEdgeId> = None;
        for _ in 0..PATIENCE {
            let beyond = |h: &HalfEdgeId| {
                Some(*h) != entered && self.draft.side_of(*h, p) == Orientation::Right
            };
            // Begins with the edge after that through which it came, as the walk of point location does.
            let first = entered.map_or(0, HalfEdgeId::slot);
            let sides = (1..=3).map(|k| at.half_edges()[(first + k) % 3]);
            let Some(h) = sides.into_iter().find(beyond) else {
                return Ok(Some(at));
            };
            if self.is_outer(h) {
                break;
            }
            let twin = self.draft.mesh.twin(h);
            (at, entered) = (twin.triangle(), Some(twin));
        }
        self.spend(3 * self.draft.mesh.num_faces())?;
        let mut all = self.draft.mesh.triangles();
        Ok(all.find(|&t| contains(&self.corners(t), p).is_some()))
    }
}

/// Tells whether a triangle contains a point, and if so, whether on its boundary.
#[inline]
pub(super) fn contains([a, b, c]: &[Point; 3], p: Point) -> Option<bool> {
    let mut is_on_border = false;
    for [from, to] in [[a, b], [b, c], [c, a]] {
        match orient2d(*from, *to, p) {
            Orientation::Right => return None,
            Orientation::Collinear => is_on_border = true,
            Orientation::Left => {}
        }
    }
    Some(is_on_border)
}
