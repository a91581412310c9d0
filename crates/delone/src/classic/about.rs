//! What there is to say of an algorithm.

use super::Input;
use crate::Error;

/// Source, idea, cost, guarantees and pseudocode of an algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct About {
    /// Its name on the command line: lower case, words joined by hyphens.
    pub name: &'static str,
    /// What people call it.
    pub title: &'static str,
    /// Where it comes from: document or paper, author, year.
    pub source: &'static str,
    /// Its idea, in a sentence or two.
    pub idea: &'static str,
    /// Expected and worst time, in the number n of points.
    pub cost: &'static str,
    /// What the result is, and what it is not.
    pub guarantees: &'static str,
    /// What it works on.
    pub takes: Takes,
    /// Whether it ends in the canonical (constrained) Delaunay triangulation.
    pub is_delaunay: bool,
    /// Its pseudocode; [`Step::line`](crate::Step::line) counts from 1. Indented by two spaces a level.
    pub code: &'static [&'static str],
}

/// What an algorithm works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Takes {
    /// Points alone.
    Points,
    /// Points, and a triangulation of them to begin with, if there is one; else it begins with that of
    /// the [sweep](super::Algorithm::Sweep). Segments are constraints.
    Triangulation,
    /// Points and segments.
    Domain,
    /// Points that are no vertices, but data to be covered.
    Data,
}

impl About {
    /// Refuses what the algorithm does not know.
    pub(super) fn require_taken(&self, input: &Input) -> Result<(), Error> {
        let refuse = |what| {
            let algorithm = self.name;
            Err(Error::NotTaken { algorithm, what })
        };
        if matches!(self.takes, Takes::Points | Takes::Data) && !input.pslg.segments.is_empty() {
            return refuse("segments");
        }
        if self.takes != Takes::Triangulation && !input.start.is_empty() {
            return refuse("triangulation to begin with");
        }
        Ok(())
    }
}
