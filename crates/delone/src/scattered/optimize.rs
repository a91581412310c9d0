//! Flips, around a new vertex or anywhere: chapter 3.21, with the extended max-min-angle criterion (3.37).
//!
//! The text calls what comes out locally optimal: it is at the edges opposite the vertex when they are looked at. It
//! is not Delaunay in general, since an edge stays whose flip would leave a triangle with too few data.

use super::field::Field;
use crate::{Error, HalfEdgeId, Observer, VertexId};

impl<O: Observer> Field<'_, O> {
    /// Goes once around vertex `v`, counter-clockwise, and flips the edges opposite to it as long as that makes
    /// angles larger and leaves at least `least` data on both sides; returns the number of flips.
    ///
    /// Begins at the neighbour of lowest number, or, at a vertex of the outline, at the one that follows it there.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub(super) fn optimize(&mut self, v: VertexId, least: usize) -> Result<usize, Error> {
        let mut flips = 0;
        let mut spoke = self.first_spoke(v);
        let last = self.draft.mesh.dest(spoke);
        loop {
            let opposite = spoke.next();
            while self.swap(opposite, least)? {
                flips += 1;
            }
            spoke = self.draft.mesh.twin(opposite.next());
            let mesh = &self.draft.mesh;
            if mesh.dest(spoke) == last || mesh.is_ghost(spoke.triangle()) {
                return Ok(flips);
            }
        }
    }

    /// Flips edges, wherever they are, until none can be flipped.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub(super) fn optimize_all(&mut self, least: usize) -> Result<usize, Error> {
        let mesh = &self.draft.mesh;
        let mut suspects: Vec<_> = mesh.half_edges().filter(|&h| h < mesh.twin(h)).collect();
        let mut flips = 0;
        while let Some(h) = suspects.pop() {
            if self.swap(h, least)? {
                flips += 1;
                let g = self.draft.mesh.twin(h.next()).prev();
                suspects.extend([h, h.prev(), g, g.prev()]);
            }
        }
        Ok(flips)
    }

    fn first_spoke(&self, v: VertexId) -> HalfEdgeId {
        let mesh = &self.draft.mesh;
        let on_outline = self.draft.star(v).find(|&h| {
            let beyond = mesh.twin(h).triangle();
            mesh.is_ghost(beyond) && !mesh.is_ghost(h.triangle())
        });
        let lowest = || self.draft.star(v).min_by_key(|&h| mesh.dest(h));
        on_outline
            .or_else(lowest)
            .expect("bug: the vertex is not in the mesh")
    }
}
