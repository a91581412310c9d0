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
//! Of equals, numbers decide: those of edges and triangles in the thesis' [tables](crate::tables), which
//! therefore are kept as it keeps them. The print's errors are corrected as its examples demand.
//!
//! *Guaranteed*: what phase 1 reaches, if budget and precision allow; and a valid mesh, whatever happens.
//! *Not guaranteed*: any angle. There are no shells around sharp corners and no rule about encroachment; the
//! 1/100 rule may give up on easy domains, and nothing but it, the budget and the grid of `f64` ends phase
//! 2. The [default](super::Strategy::Delaunay) knows better; this one is here to be studied.
//!
//! *Departures*: four points on a circle are decided by the symbolic perturbation; signs, visibility and right
//! angles are exact; lines within the domain are constraints, too; and the mesh it starts from is the
//! canonical one, numbered as the sweep of the thesis would [number](crate::tables::tables_of) it. A vertex that would invert
//! a triangle by rounding stops the work.
//!
//! *Cost*: O(log n) for each vertex, and for each edge examined: there is no search through all edges.

mod code;
mod limits;
mod opening;
mod queues;
mod sight;
mod split;
#[cfg(test)]
mod tests;
mod verdict;
mod work;

use super::picture::Picture;
use super::{Encroachment, Locked, Outcome, RefinedMesh, Refinement, handing};
use crate::constrained::{Prepared, Steiner, extend};
use crate::parallel::Workers;
use crate::{
    ConstrainedTriangulation, DomainRule, Error, Event, Observer, Quality, Stage, VertexId,
};
pub(crate) use code::CODE;
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
    let mut progress = Progress::default();
    let mut limits = Limits::new(refinement.budget, refinement.watch);
    run.tell_start(&mut progress, observer);
    let outcome = run.stages(&mut progress, &mut limits, observer)?;
    if outcome != Outcome::FellBack {
        progress.saved.push(progress.steiner.points.len());
    }
    let (mesh, outcome) = run.hand_out(&mut progress, outcome, observer)?;
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

/// What has been done.
struct Progress {
    steiner: Steiner,
    /// What each stage has left behind, as a number of vertices added.
    saved: Vec<usize>,
    /// What whoever watches sees; empty if nobody does.
    shown: Picture,
}

impl Default for Progress {
    fn default() -> Self {
        Self {
            steiner: Steiner::default(),
            saved: vec![0],
            shown: Picture::default(),
        }
    }
}

impl Run<'_> {
    /// Takes one stage after the other until something stops them, and says what.
    fn stages(
        &self,
        progress: &mut Progress,
        limits: &mut Limits,
        observer: &mut impl Observer,
    ) -> Result<Outcome, Error> {
        let bound = self.quality.max_edge.unwrap_or(f64::INFINITY);
        let steiner = &mut progress.steiner;
        let divided = split::split_edges(self.start, bound, steiner, limits, observer);
        if observer.is_watching() {
            progress.shown = Picture::of_segments(self.start, steiner);
        }
        if let Err(why) = divided {
            return Ok(why);
        }
        observer.tell(code::SEGMENTS, || Event::StageEnded {
            stage: Stage::SplitEdges,
            min_angle: None,
        });
        let Some(mesh) = self.mesh(steiner, steiner.points.len())? else {
            return Ok(Outcome::PrecisionLimit);
        };
        progress.saved.push(steiner.points.len());
        if observer.is_watching() {
            let points = mesh.triangulation().points();
            let (shown, to) = (&mut progress.shown, Picture::of_mesh(&mesh));
            shown.turn_into(to, points, code::MESH, observer);
        }
        let is_watched = observer.is_watching();
        let mut work = Work::new(&mesh, steiner, limits, observer);
        let outcome = self.phases(&mut work, bound, &mut progress.saved);
        let triangles: Option<Vec<_>> = is_watched.then(|| work.triangles().collect());
        if let Some(triangles) = triangles.filter(|t| !t.is_empty()) {
            progress.shown = Picture::of_segments(self.start, steiner).with(triangles);
        }
        Ok(outcome.err().unwrap_or(Outcome::Complete))
    }

    /// Takes the two phases, unless something stops them.
    fn phases<O: Observer>(
        &self,
        work: &mut Work<O>,
        bound: f64,
        saved: &mut Vec<usize>,
    ) -> Result<(), Outcome> {
        work.shorten(bound)?;
        saved.push(work.num_steiner());
        if let Some(angle) = self.quality.min_angle {
            work.open(angle)?;
        }
        match work.keeps_to(bound) {
            true => Ok(()),
            false => Err(Outcome::FellBack),
        }
    }

    /// Makes the mesh of the last stage that rounding has not spoilt: vertices on the border may have
    /// met what lies beyond, which no stage looks at.
    fn hand_out(
        &self,
        progress: &mut Progress,
        mut outcome: Outcome,
        observer: &mut impl Observer,
    ) -> Result<(ConstrainedTriangulation, Outcome), Error> {
        while let Some(count) = progress.saved.pop() {
            if let Some(mesh) = self.mesh(&progress.steiner, count)? {
                self.tell_result(&mesh, progress, observer);
                return Ok((mesh, outcome));
            }
            outcome = Outcome::PrecisionLimit;
        }
        unreachable!("bug: without new vertices the mesh is what it was")
    }

    /// Lays out the segments, and the vertices where they cross.
    fn tell_start(&self, progress: &mut Progress, observer: &mut impl Observer) {
        if observer.is_watching() {
            progress.shown = Picture::of_points(self.start.num_input_points());
            let to = Picture::of_segments(self.start, &Steiner::default());
            let points = self.start.triangulation().points();
            progress.shown.turn_into(to, points, 0, observer);
        }
    }

    /// Tells of all that leads from what was made to what is handed out: nothing, if all went well.
    fn tell_result(
        &self,
        mesh: &ConstrainedTriangulation,
        progress: &mut Progress,
        observer: &mut impl Observer,
    ) {
        if !observer.is_watching() {
            return;
        }
        let added = &progress.steiner.points;
        let points = [self.start.triangulation().points(), added].concat();
        let kept = mesh.triangulation().points().len();
        // If the segments were never all divided, there has been no mesh to see.
        let is_taken_back = kept < points.len();
        let line = match is_taken_back || progress.shown.has_triangles() {
            true => code::RETURN,
            false => code::MESH,
        };
        if is_taken_back {
            let from = VertexId::new(kept);
            observer.tell(line, || Event::TakenBack { from });
        }
        let to = Picture::of_mesh(mesh);
        progress.shown.turn_into(to, &points, line, observer);
    }

    fn mesh(
        &self,
        steiner: &Steiner,
        count: usize,
    ) -> Result<Option<ConstrainedTriangulation>, Error> {
        extend(self.start, steiner, count, self.workers)
    }
}
