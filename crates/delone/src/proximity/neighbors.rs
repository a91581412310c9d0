//! The closest pair, and everyone's nearest neighbour.
//!
//! The circle whose diameter runs from a point to any of its nearest neighbours has no other point in it
//! or on it, so they are neighbours in every Delaunay triangulation, ties included (Shamos and Hoey,
//! *Closest-point problems*, 1975).

use super::Proximity;
use super::edges::Candidate;
use crate::predicates::squared_length;
use crate::{Error, VertexId};

impl Proximity<'_> {
    /// Finds the two distinct points that are closest to each other, lower index first; of several such
    /// pairs the lexicographically first. `None` if there are fewer than two.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n).
    pub fn closest_pair(&self) -> Result<Option<[VertexId; 2]>, Error> {
        let mut pace = self.pace();
        let mut closest = None;
        for h in self.half_edges() {
            pace.step()?;
            if closest.is_none_or(|c| self.compare_edges(h, c).is_lt()) {
                closest = Some(h);
            }
        }
        pace.finish();
        Ok(closest.map(|h| self.undirected(h)))
    }

    /// Finds the nearest other vertex of every point; of several the one of lowest index. `None` stands
    /// for a duplicate, and for the only vertex.
    ///
    /// This is the nearest-neighbour graph: each edge leads from a vertex to an entry.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n).
    pub fn nearest_neighbors(&self) -> Result<Vec<Option<VertexId>>, Error> {
        let mut pace = self.pace();
        let mut nearest: Vec<Option<Candidate>> = vec![None; self.triangulation.points().len()];
        for h in self.half_edges() {
            pace.step()?;
            let [a, b] = self.ends(h);
            let square = squared_length(self.end_points(h));
            for (from, to) in [(a, b), (b, a)] {
                let new = Candidate { to, square };
                let best = &mut nearest[from.index()];
                if best.is_none_or(|old| new.is_nearer(from, old, |v| self.point(v))) {
                    *best = Some(new);
                }
            }
        }
        pace.finish();
        Ok(nearest.into_iter().map(|n| n.map(|c| c.to)).collect())
    }
}
