//! Triangles that hold more than 3d − 1 data, and what excuses that.
//!
//! A vertex inside such a triangle would make three of it. The part opposite a corner has nothing of the
//! two edges at that corner but their outer ends, and nothing of the opposite edge goes to the other two but its ends.
//! So no vertex leaves d data to each part
//! * if without those on one open edge fewer than 2d are left, for the two other parts;
//! * if without those on two edges, the outer ends left, fewer than d are left, for the third part.
//!
//! Where neither is so a place exists for the vertex, if parts may share what lies between them; but
//! whether a point with double-precision coordinates is such a place cannot be told from the arrays. Those triangles
//! are listed as unexcused.

use super::CoverVerifier;
use super::held::Held;
use crate::predicates::{Orientation, orient2d};
use crate::{Error, Point, TriangleId, VertexId};

/// A triangle that holds more than 3d − 1 data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SpecialCase {
    /// The triangle.
    pub triangle: TriangleId,
    /// How many data it holds, equal ones once.
    pub data: usize,
    /// What excuses it.
    pub cause: SpecialCause,
}

/// What may excuse a triangle that holds more than 3d − 1 data. Of several excuses the first counts, and of
/// several edges or corners the one that comes first in the triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpecialCause {
    /// Without the data on one of its open edges it holds fewer than 2d, so no vertex inside makes three parts
    /// with d each.
    Edge {
        /// The ends of the edge; the first edge lies opposite the first corner.
        edge: [VertexId; 2],
        /// How many of its data lie on the open edge.
        data: usize,
    },
    /// Without the data on two of its edges, the common end included and the other ends not, it holds fewer than
    /// d, so likewise.
    TwoEdges {
        /// The common end.
        corner: VertexId,
        /// How many of its data lie there.
        data: usize,
    },
    /// Nothing. Perhaps there is no room for a vertex with double-precision coordinates; nobody can tell from the
    /// result.
    Unexcused,
}

/// Lists the triangles that hold too many, ascending.
pub(super) fn list(cover: &mut CoverVerifier, held: &Held) -> Result<Vec<SpecialCase>, Error> {
    let bound = cover.least.saturating_mul(3);
    let is_special = |t: &usize| cover.least > 0 && held.counts[*t] >= bound;
    let special: Vec<usize> = (0..held.counts.len()).filter(is_special).collect();
    let tallies = tally(cover, held, &special)?;
    let cases = special.iter().zip(tallies).map(|(&t, tally)| SpecialCase {
        triangle: TriangleId::new(t),
        data: held.counts[t],
        cause: tally.cause(held.counts[t], cover.least, cover.verifier.triangles[t]),
    });
    Ok(cases.collect())
}

/// Counts where in the triangles `special`, which ascend, their data lie.
fn tally(cover: &mut CoverVerifier, held: &Held, special: &[usize]) -> Result<Vec<Tally>, Error> {
    let mut tallies = vec![Tally::default(); special.len()];
    if special.is_empty() {
        return Ok(tallies);
    }
    for (datum, &at) in cover.data.iter().enumerate() {
        cover.verifier.pace.step()?;
        let holder = cover.holders[datum];
        if !held.is_first[datum] {
            continue;
        }
        if let Ok(slot) = special.binary_search(&holder.index()) {
            tallies[slot].add(cover.places(holder), at);
        }
    }
    Ok(tallies)
}

/// How many data of a triangle lie on its edges.
#[derive(Clone, Default)]
struct Tally {
    /// Upon each corner.
    corners: [usize; 3],
    /// On the open edge opposite each corner.
    edges: [usize; 3],
}

impl Tally {
    /// Counts a datum in the closed triangle.
    fn add(&mut self, corners: [Point; 3], datum: Point) {
        if let Some(k) = corners.iter().position(|&corner| corner == datum) {
            self.corners[k] += 1;
            return;
        }
        let is_on = |k: &usize| {
            let [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            orient2d(a, b, datum) == Orientation::Collinear
        };
        if let Some(k) = (0..3).find(is_on) {
            self.edges[k] += 1;
        }
    }

    /// Finds what excuses that the triangle holds `held` data.
    fn cause(&self, held: usize, least: usize, corners: [VertexId; 3]) -> SpecialCause {
        let twice = least.saturating_mul(2);
        if let Some(k) = (0..3).find(|&k| held - self.edges[k] < twice) {
            return SpecialCause::Edge {
                edge: [corners[(k + 1) % 3], corners[(k + 2) % 3]],
                data: self.edges[k],
            };
        }
        let around = |k: usize| self.corners[k] + self.edges[(k + 1) % 3] + self.edges[(k + 2) % 3];
        match (0..3).find(|&k| held - around(k) < least) {
            Some(k) => SpecialCause::TwoEdges {
                corner: corners[k],
                data: around(k),
            },
            None => SpecialCause::Unexcused,
        }
    }
}
