//! The Delaunay refinement of this library, watched at work; see [`Strategy::Delaunay`], which this is.
//!
//! The loop itself tells what it does; what it begins with, a domain with its segments
//! [inserted](super::constrained), is laid out first, in steps of line 0.

use super::{About, Input, Output, Takes};
use crate::refine::{DELAUNAY_CODE, Refinement, Strategy};
use crate::{Budget, Error, Observer, Outcome};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "refinement",
    title: "Delaunay refinement",
    source: "Ruppert 1995; Chew 1993; Üngör 2004; Erten and Üngör 2007; Miller, Pav and Walkington 2003",
    idea: "Put a vertex where a bad triangle has an empty circle; but where that would come too close to a segment, \
           split the segment instead.",
    cost: "constant in practice for each vertex that is added; how many, the goals decide",
    guarantees: "ends for every input and angle, in a constrained Delaunay mesh; in practice up to 33°, but for \
                 angles of the input",
    takes: Takes::Domain,
    is_delaunay: true,
    code: DELAUNAY_CODE,
};

/// Most vertices: what is studied is far smaller, and a bound that has lost a digit must not fill the memory.
const MOST: usize = 2_000_000;

/// Refines the domain up to what `input.quality` asks for.
pub(super) fn run(input: &Input, observer: &mut (impl Observer + Send)) -> Result<Output, Error> {
    refine(input, Strategy::Delaunay, ABOUT.name, observer)
}

/// Refines the domain by a strategy, which goes by the name of an algorithm.
pub(super) fn refine(
    input: &Input,
    strategy: Strategy,
    algorithm: &'static str,
    observer: &mut (impl Observer + Send),
) -> Result<Output, Error> {
    let refinement = Refinement::new(input.quality)
        .strategy(strategy)
        .domain(input.domain)
        .threads(1)
        .budget(Budget {
            vertices: Some(MOST),
            ..Budget::default()
        })
        .watch(input.watch);
    let refined = refinement.observe(input.pslg.clone(), observer)?;
    match refined.report.outcome {
        Outcome::Cancelled => Err(Error::Cancelled),
        Outcome::BudgetExhausted => Err(Error::TooManyVertices {
            algorithm,
            limit: MOST,
        }),
        _ => Ok(Output::of_domain(&refined.mesh)),
    }
}
