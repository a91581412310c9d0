//! What Steiner points inherit: those on segments from both sides along them, free ones from the
//! triangle that was there before.

use super::interpolate;
use super::surface::Surface;
use crate::unrefined::pieces;
use crate::{Attribute, Error};
use delone::{ConstrainedTriangulation, VertexId, Watch};

/// The Steiner points of a result, and where each of them lies in what was there before.
pub(super) struct Steiner<'a> {
    result: &'a ConstrainedTriangulation,
    /// The first of them; all vertices behind it are Steiner points too.
    first: usize,
    /// For each of them the vertices next to it on its segment that are none; `None` if it is free.
    brackets: Vec<Option<[VertexId; 2]>>,
}

impl<'a> Steiner<'a> {
    /// *Cost*: proportional to the chains.
    pub fn of(result: &'a ConstrainedTriangulation) -> Self {
        let mut steiner = Self {
            result,
            first: result.num_input_points() + result.num_crossings(),
            brackets: vec![None; result.num_steiner()],
        };
        for segment in 0..result.segments().len() {
            steiner.bracket(segment);
        }
        steiner
    }

    /// Notes the neighbours of the Steiner points along one segment, but for those known already.
    fn bracket(&mut self, segment: usize) {
        for piece in pieces(self.result.chain(segment), self.first) {
            let [from, between @ .., to] = piece else {
                continue;
            };
            for v in between {
                let place = &mut self.brackets[v.index() - self.first];
                place.get_or_insert([*from, *to]);
            }
        }
    }

    /// Appends the attributes of the Steiner points to those of all other vertices.
    pub fn add_attributes(
        &self,
        attributes: &mut [Attribute],
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        if attributes.is_empty() {
            return Ok(());
        }
        let is_any_free = self.brackets.contains(&None);
        let surface = is_any_free.then(|| self.surface(watch)).transpose()?;
        for Attribute { values, .. } in attributes {
            for (i, bracket) in self.brackets.iter().enumerate() {
                let v = VertexId::new(self.first + i);
                let at = self.result.triangulation().point(v);
                values.push(match (bracket, &surface) {
                    (&Some(ends), _) => interpolate(self.result, ends, at, values),
                    (None, Some(surface)) => surface.interpolate(v, at, values),
                    (None, None) => unreachable!("bug: a free vertex without surface"),
                });
            }
        }
        Ok(())
    }

    /// Triangulates what was there before.
    fn surface(&self, watch: &dyn Watch) -> Result<Surface, Error> {
        let segments = 0..self.result.segments().len();
        let chains = segments.map(|segment| self.result.chain(segment));
        Surface::before(self.result, self.first, chains, watch)
    }
}
