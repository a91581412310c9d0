//! From a triangulated domain to a refined mesh: the loop with its budget, and what surrounds it.

use super::bounds::Bounds;
use super::code;
use super::handing;
use super::reasons;
use super::refiner::{Refiner, Step};
use super::smooth::smooth;
use super::sow::sow;
use super::telling::{Teller, tell_sown, tell_start};
use super::{Outcome, RefinedMesh, Refinement, Report};
use crate::clock::Clock;
use crate::constrained::{Prepared, enrich};
use crate::parallel::Workers;
use crate::{DomainRule, Error, Locked, Observer, Phase, Stage, Watch};

/// Steps between two looks at clock and watch.
const STRIDE: usize = 1 << 10;

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
    let shown = tell_start(&prepared, observer);
    let vertices = refinement.budget.vertices.unwrap_or(usize::MAX);
    let room = vertices.saturating_sub(prepared.points.len());
    if refinement.locked == Locked::Nothing
        && let Some(additions) = sow(&prepared, &refinement.quality, room)
    {
        prepared = enrich(prepared, additions, workers, refinement.watch)?;
        tell_sown(shown, &prepared, observer);
    }
    let scale = handing::scale(&prepared.points);
    let bounds = Bounds::new(
        &refinement.quality,
        &prepared.context.pslg.regions,
        refinement.sizing,
        refinement.encroachment,
        scale,
    );
    let sown = handing::are_sown(&prepared);
    let teller = Teller::new(&prepared, scale, observer);
    let (canvas, context) = handing::canvas(prepared, scale);
    let mut refiner = Refiner::new(canvas, sown, bounds, refinement.locked, teller);
    let clock = Clock::start();
    let stopped = work_off(&mut refiner, refinement, clock);
    refiner.teller.end(code::LOOP, Stage::Refinement);
    let ended = match stopped {
        Some(Outcome::Cancelled) => stopped,
        _ => smooth(&mut refiner, refinement, clock).or(stopped),
    };
    let unmet = reasons::unmet(&refiner.canvas, &refiner.bounds, workers);
    let Refiner { canvas, lines, .. } = refiner;
    // From here on the work is done: whoever cancels gets what there is.
    let watch = Unstoppable(refinement.watch);
    let prepared = handing::prepared(canvas, &lines, context);
    let mesh = prepared.hand_out(workers, &watch)?;
    let unmet = reasons::explain(&mesh, unmet, refinement.locked, stopped.is_some());
    let on_segments = mesh.num_on_segments();
    let is_excused = unmet.iter().all(|u| u.reason.is_excused());
    let report = Report {
        outcome: ended.unwrap_or(match is_excused {
            true => Outcome::Complete,
            false => Outcome::PrecisionLimit,
        }),
        asked: refinement.quality,
        unmet,
        on_segments,
        free: mesh.num_steiner() - on_segments,
    };
    Ok(RefinedMesh::new(mesh, report))
}

/// Goes on until nothing is left to do; returns what stopped it earlier, if anything did.
fn work_off(
    refiner: &mut Refiner<impl Observer>,
    refinement: &Refinement,
    clock: Clock,
) -> Option<Outcome> {
    let budget = refinement.budget;
    let most = budget.vertices.unwrap_or(usize::MAX);
    for steps in 0.. {
        if refiner.num_vertices() >= most && !refiner.is_finished() {
            return Some(Outcome::BudgetExhausted);
        }
        if steps % STRIDE == 0 {
            if refinement.watch.is_cancelled() {
                return Some(Outcome::Cancelled);
            }
            if budget.time.is_some_and(|time| clock.elapsed() >= time) {
                return Some(Outcome::BudgetExhausted);
            }
            let done = refiner.num_vertices() as u64;
            let total = done + refiner.backlog() as u64;
            refinement.watch.progress(Phase::Refine, done, total);
        }
        if refiner.step() == Step::Finished {
            break;
        }
    }
    None
}

/// Tells of progress, and does not ask.
struct Unstoppable<'a>(&'a dyn Watch);

impl Watch for Unstoppable<'_> {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        self.0.progress(phase, done, total);
    }
}
