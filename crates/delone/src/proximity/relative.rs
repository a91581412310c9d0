//! The relative neighbourhood graph (Toussaint, *The relative neighbourhood graph of a finite planar
//! set*, 1980).
//!
//! An edge ab belongs to it if no point lies in the lune: nearer to both ends than they are to each other.
//! Those nearer to a than b is are found by a flood through the triangulation that begins at a and never
//! leaves the circle: each of its points other than a has a neighbour nearer to a. The lune lies in the
//! circles about both ends, so floods from both take turns, and the first that runs dry has proven it
//! empty.
//!
//! *Cost*: for each edge of the Gabriel graph the smaller one of the two circles' contents. Constant for
//! evenly spread points; O(n²) in all at worst, where many long edges of the graph end in dense places on
//! either side. (Supowit, *The relative neighborhood graph, with an application to minimum spanning
//! trees*, 1983, needs O(n log n), but directions that `f64` cannot name.)

use super::Proximity;
use crate::predicates::compare_distances;
use crate::{Error, HalfEdgeId, Point, VertexId};

impl Proximity<'_> {
    /// Lists the edges of the relative neighbourhood graph: those pairs of vertices for which no other is
    /// nearer to both than they are to each other. Lower end first, sorted.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    ///
    /// *Cost*: O(n log n) for evenly spread points, O(n²) at worst.
    pub fn relative_neighborhood_graph(&self) -> Result<Vec<[VertexId; 2]>, Error> {
        let mut pace = self.pace();
        let mut search = Search {
            proximity: self,
            seen: vec![0; self.triangulation.points().len()],
            round: 0,
            waiting: [Vec::new(), Vec::new()],
        };
        let mut edges = Vec::new();
        for h in self.half_edges() {
            pace.step()?;
            if self.is_gabriel(h) && !search.is_lune_taken(h, &mut || pace.step())? {
                edges.push(self.undirected(h));
            }
        }
        edges.sort_unstable();
        pace.finish();
        Ok(edges)
    }
}

/// Two floods, with room for them that is used again.
struct Search<'p, 't> {
    proximity: &'p Proximity<'t>,
    /// The last flood that has come to a vertex.
    seen: Vec<u32>,
    /// Floods so far.
    round: u32,
    waiting: [Vec<VertexId>; 2],
}

impl Search<'_, '_> {
    /// Tells whether a vertex lies in the lune of the edge of `h`.
    fn is_lune_taken(
        &mut self,
        h: HalfEdgeId,
        step: &mut dyn FnMut() -> Result<(), Error>,
    ) -> Result<bool, Error> {
        let ends = self.proximity.ends(h);
        self.begin(ends);
        loop {
            for side in [0, 1] {
                step()?;
                let Some(v) = self.waiting[side].pop() else {
                    return Ok(false);
                };
                if self.spread(side, v, ends) {
                    return Ok(true);
                }
            }
        }
    }

    fn begin(&mut self, ends: [VertexId; 2]) {
        if self.round >= u32::MAX - 2 {
            self.seen.fill(0);
            self.round = 0;
        }
        self.round += 2;
        for (waiting, end) in self.waiting.iter_mut().zip(ends) {
            waiting.clear();
            waiting.push(end);
        }
    }

    /// Lets the flood of `side` spread to the neighbours of `v`; true if it comes to the lune.
    ///
    /// A vertex in both floods would lie in the lune, so one mark for each is enough.
    fn spread(&mut self, side: usize, v: VertexId, ends: [VertexId; 2]) -> bool {
        let proximity = self.proximity;
        let mesh = proximity.triangulation.mesh();
        let [centre, other] = [ends[side], ends[1 - side]];
        let [p, q]: [Point; 2] = [centre, other].map(|v| proximity.point(v));
        let mark = self.round + side as u32;
        for h in proximity.triangulation.star(v) {
            let w = mesh.dest(h);
            if w.is_infinite() || w == centre || self.seen[w.index()] == mark {
                continue;
            }
            let r = proximity.point(w);
            if compare_distances(p, r, q).is_lt() {
                if compare_distances(q, r, p).is_lt() {
                    return true;
                }
                self.seen[w.index()] = mark;
                self.waiting[side].push(w);
            }
        }
        false
    }
}
