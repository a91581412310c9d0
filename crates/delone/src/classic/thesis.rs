//! The thesis' pipeline from segments to a mesh of good triangles; see
//! [`Strategy::Thesis`](crate::Strategy::Thesis), which this is.
//!
//! *Corrected*: the loop that divides segments (as printed it writes edges from a vertex to itself); the
//! triangle that contains a circumcenter is judged by its own lengths, not by those of the triangle to be
//! opened; a circumcenter outside of the domain is hidden, not looked at along a whole line; the angle
//! reached is compared in one unit, where the print compares degrees with radians and so nearly always keeps
//! the unfinished mesh. Four points on a circle are decided by the perturbation.
//!
//! *Not done*: the first `edge_flip` of the whole mesh, which begins as the constrained Delaunay
//! triangulation; [edge-flip](super::Algorithm::EdgeFlip) shows it.

use super::{About, Input, Output, Takes, refinement};
use crate::refine::{Strategy, THESIS_CODE};
use crate::{Error, Observer};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "thesis",
    title: "refinement by bisection and circumcenters",
    source: "Thesis on constrained Delaunay triangulation and refinement, Ulm 2012",
    idea: "Divide segments evenly, bisect edges that are too long, then open the skinniest triangle, again \
           and again, flipping after each step.",
    cost: "O(log n) for each vertex that is added and each edge that is examined; how many, the goals decide",
    guarantees: "a constrained Delaunay mesh with no edge longer than h; no angle",
    takes: Takes::Domain,
    is_delaunay: true,
    code: THESIS_CODE,
};

/// Refines the domain up to the smallest angle and the longest edge of `input.quality`.
pub(super) fn run(input: &Input, observer: &mut (impl Observer + Send)) -> Result<Output, Error> {
    refinement::refine(input, Strategy::Thesis, ABOUT.name, observer)
}
