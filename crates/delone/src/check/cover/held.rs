//! Who holds which datum, and does it lie there?

use super::super::Defect;
use super::super::positions::{Place, place};
use super::CoverVerifier;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point};
use std::collections::HashMap;

/// How many data triangles hold.
pub(super) struct Held {
    /// For each triangle, equal data once.
    pub counts: Vec<usize>,
    /// For each datum whether it equals no earlier one.
    pub is_first: Vec<bool>,
    /// How many data equal an earlier one.
    pub duplicates: usize,
}

impl Held {
    /// Counts; reports data that do not lie where they are held, and equal ones that are held by different triangles.
    /// Triangles that are not `upright` have been reported, and are not asked what lies in them.
    pub fn find(cover: &mut CoverVerifier, upright: &[bool]) -> Result<Self, Error> {
        let (data, holders) = (cover.data.len(), cover.holders.len());
        let mut held = Self {
            counts: vec![0; upright.len()],
            is_first: vec![false; data],
            duplicates: 0,
        };
        if data != holders {
            let defect = Defect::HolderCount { data, holders };
            cover.verifier.defects.push(defect);
            return Ok(held);
        }
        let mut first_at: HashMap<Place, usize> = HashMap::with_capacity(data);
        for datum in 0..data {
            cover.verifier.pace.step()?;
            let first = *first_at.entry(place(cover.data[datum])).or_insert(datum);
            held.count(cover, datum, first);
            held.check(cover, datum, first, upright);
        }
        Ok(held)
    }

    /// Counts a datum unless it equals an earlier one.
    fn count(&mut self, cover: &CoverVerifier, datum: usize, first: usize) {
        let is_first = datum == first;
        self.is_first[datum] = is_first;
        self.duplicates += usize::from(!is_first);
        if let Some(count) = self.counts.get_mut(cover.holders[datum].index()) {
            *count += usize::from(is_first);
        }
    }

    /// Tests a datum, of which `first` is the first that equals it.
    fn check(&self, cover: &mut CoverVerifier, datum: usize, first: usize, upright: &[bool]) {
        let [holder, first_holder] = [datum, first].map(|datum| cover.holders[datum]);
        let at = cover.data[datum];
        let triangles = upright.len();
        let defects = &mut cover.verifier.defects;
        if holder.index() >= triangles {
            defects.push(Defect::HolderOutOfRange {
                datum,
                holder,
                triangles,
            });
        } else if holder != first_holder {
            defects.push(Defect::DividedDatum {
                data: [first, datum],
                holders: [first_holder, holder],
            });
        } else if upright[holder.index()] && !contains(cover.places(holder), at) {
            let defects = &mut cover.verifier.defects;
            defects.push(Defect::OutsideHolder { datum, at, holder });
        }
    }

    /// Counts the triangles that hold 0, 1, 2 … data.
    pub fn histogram(&self) -> Vec<usize> {
        let most = self.counts.iter().copied().max();
        let mut histogram = vec![0; most.map_or(0, |most| most + 1)];
        self.counts.iter().for_each(|&held| histogram[held] += 1);
        histogram
    }
}

/// Tells whether `p` is a point of the closed triangle, whose corners are counter-clockwise.
fn contains([a, b, c]: [Point; 3], p: Point) -> bool {
    let is_right = |from, to| orient2d(from, to, p) == Orientation::Right;
    p.is_finite() && !is_right(a, b) && !is_right(b, c) && !is_right(c, a)
}
