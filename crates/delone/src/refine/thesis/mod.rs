//! The strategy of the thesis that this project goes back to (Ulm, 2012), step by step as it is written.
//!
//! ```text
//! split_edges ──> mesh ──> phase 1: bisect longest edges ──> phase 2: open skinny triangles ──> done
//!                                                 │                        │ too small
//!                                                 └──────── the result <───┘
//! ```
//!
//! 1. *Split edges*: segments longer than the largest edge wanted are divided evenly.
//! 2. *Phase 1*: while the longest edge is too long, it is bisected; then edges are flipped until all are
//!    locally Delaunay. This always reaches the largest edge wanted.
//! 3. *Phase 2*: the skinniest triangle is [opened](opening); then edges are flipped. Triangles whose angle
//!    is given by two segments are left alone. It goes on until none is skinny, or the area of the
//!    skinniest is at most a hundredth of what it was at first. Then, or if an edge has become too long,
//!    the result is the mesh of phase 1, and its outcome says so.
//!
//! Of equals, numbers decide: those of edges and triangles in the thesis' [tables], which therefore are
//! kept as it keeps them. The print's errors are corrected as its examples demand.
//!
//! *Guaranteed*: what phase 1 reaches, if budget and precision allow; and a valid mesh, whatever happens.
//! *Not guaranteed*: any angle. There are no shells around sharp corners and no rule about encroachment; the
//! 1/100 rule may give up on easy domains, and nothing but it, the budget and the grid of `f64` ends phase
//! 2. The [default](super::Strategy::Delaunay) knows better; this one is here to be studied.
//!
//! *Departures*: four points on a circle are decided by the symbolic perturbation; signs, visibility and right
//! angles are exact; lines within the domain are constraints, too; and the mesh it starts from is the
//! canonical one, numbered as the sweep of the thesis would [number](numbering) it. A vertex that would invert
//! a triangle by rounding stops the work.
//!
//! *Cost*: O(log n) for each vertex, and for each edge examined: there is no search through all edges.

mod edits;
mod flips;
mod limits;
mod numbering;
mod opening;
mod queues;
mod shape;
mod sight;
mod split;
mod tables;
#[cfg(test)]
mod tests;
mod verdict;
mod work;

use super::{Encroachment, Locked, Outcome, RefinedMesh, Refinement, handing};
use crate::constrained::{Prepared, Steiner, extend};
use crate::parallel::Workers;
use crate::{
    ConstrainedTriangulation, DomainRule, Error, Event, Observer, Quality, Stage, VertexId,
};
use limits::Limits;
use work::Work;

/// Refines a domain that is triangulated and carved.
pub(super) fn refine(
    mut prepared: Prepared,
    refinement: &Refinement,
    workers: Workers,
    observer: &mut impl Observer,
) -> Result<RefinedMesh, Error> {
    if refinement.options.domain == DomainRule::Hull {
        handing::close_hull(&mut prepared);
    }
    let run = Run {
        start: &prepared.hand_out(workers, refinement.watch)?,
        quality: refinement.quality,
        workers,
    };
    let mut steiner = Steiner::default();
    // What each stage has left behind, as a number of vertices added.
    let mut saved = vec![0];
    let mut limits = Limits::new(refinement.budget, refinement.watch);
    let outcome = run.stages(&mut steiner, &mut saved, &mut limits, observer)?;
    if outcome != Outcome::FellBack {
        saved.push(steiner.points.len());
    }
    let (mesh, outcome) = run.hand_out(&steiner, saved, outcome, observer)?;
    let report = verdict::report(&mesh, refinement.quality, outcome);
    Ok(RefinedMesh::new(mesh, report))
}

/// Refuses what the thesis does not know.
pub(super) fn require_known(refinement: &Refinement) -> Result<(), Error> {
    let asked = [
        (refinement.sizing.is_some(), "sizing field"),
        (refinement.quality.max_area.is_some(), "largest area"),
        (refinement.quality.region_areas, "largest area by region"),
        (refinement.locked != Locked::Nothing, "locked edges"),
        (
            refinement.encroachment != Encroachment::default(),
            "conforming mesh",
        ),
        (refinement.smoothing > 0, "smoothing"),
    ];
    match asked.into_iter().find(|(is_asked, _)| *is_asked) {
        Some((_, what)) => Err(Error::NotInThesis { what }),
        None => Ok(()),
    }
}

/// What does not change while refining.
struct Run<'a> {
    start: &'a ConstrainedTriangulation,
    quality: Quality,
    workers: Workers,
}

impl Run<'_> {
    /// Takes one stage after the other until something stops them, and says what.
    fn stages(
        &self,
        steiner: &mut Steiner,
        saved: &mut Vec<usize>,
        limits: &mut Limits,
        observer: &mut impl Observer,
    ) -> Result<Outcome, Error> {
        let bound = self.quality.max_edge.unwrap_or(f64::INFINITY);
        if let Err(why) = split::split_edges(self.start, bound, steiner, limits, observer) {
            return Ok(why);
        }
        observer.tell(0, || Event::StageEnded {
            stage: Stage::SplitEdges,
            min_angle: None,
        });
        let Some(mesh) = self.mesh(steiner, steiner.points.len())? else {
            return Ok(Outcome::PrecisionLimit);
        };
        saved.push(steiner.points.len());
        let mut work = Work::new(&mesh, steiner, limits, observer);
        let shortened = work.shorten(bound);
        if let Err(why) = shortened {
            return Ok(why);
        }
        saved.push(work.num_steiner());
        if let Some(Err(why)) = self.quality.min_angle.map(|angle| work.open(angle)) {
            return Ok(why);
        }
        Ok(if work.keeps_to(bound) {
            Outcome::Complete
        } else {
            Outcome::FellBack
        })
    }

    /// Makes the mesh of the last stage that rounding has not spoilt: vertices on the border may have
    /// met what lies beyond, which no stage looks at.
    fn hand_out(
        &self,
        steiner: &Steiner,
        mut saved: Vec<usize>,
        mut outcome: Outcome,
        observer: &mut impl Observer,
    ) -> Result<(ConstrainedTriangulation, Outcome), Error> {
        while let Some(count) = saved.pop() {
            if let Some(mesh) = self.mesh(steiner, count)? {
                if count < steiner.points.len() {
                    let first = self.start.triangulation().points().len();
                    let from = VertexId::new(first + count);
                    observer.tell(0, || Event::TakenBack { from });
                }
                return Ok((mesh, outcome));
            }
            outcome = Outcome::PrecisionLimit;
        }
        unreachable!("bug: without new vertices the mesh is what it was")
    }

    fn mesh(
        &self,
        steiner: &Steiner,
        count: usize,
    ) -> Result<Option<ConstrainedTriangulation>, Error> {
        extend(self.start, steiner, count, self.workers)
    }
}
