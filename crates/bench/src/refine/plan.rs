//! Which cells are checked and timed, in which order.
//!
//! For every outline, load and angle: each mesher's result is checked in a process of its own, then
//! those that did not fail are timed in turns (warm-up rounds, then rounds that count). A mesher that
//! took too long on an outline is not tried there at a harder goal. One that cannot be asked for an
//! angle runs at the first angle only.

use super::goal::{Goal, Load, Outline};
use super::job::{Answer, Job};
use super::mesher::Mesher;
use super::quality::Quality;
use crate::effort::Effort;
use crate::measure::Cost;
use crate::plan::agree;
use crate::process::Fault;
use crate::workshop::Worker;
use std::time::Duration;

/// The area of a mesh must be that of its domain, up to the rounding of vertices on segments.
const AREA_SLACK: f64 = 1e-9;

/// What to measure, and how carefully.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Who takes part.
    pub meshers: Vec<Mesher>,
    /// On which outlines.
    pub outlines: Vec<Outline>,
    /// Bounds on areas.
    pub loads: Vec<Load>,
    /// Smallest angles, degrees.
    pub angles: Vec<f64>,
    /// How carefully.
    pub effort: Effort,
}

/// All about one mesher at one goal on one outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// What is meshed.
    pub outline: Outline,
    /// How large the mesh shall be.
    pub load: Load,
    /// What is asked of it.
    pub goal: Goal,
    /// Who meshes.
    pub mesher: Mesher,
    /// What the mesh is like.
    pub mesh: Result<Quality, Fault>,
    /// The runs that count.
    pub runs: Vec<Cost>,
}

impl Plan {
    /// Carries the plan out; `tell` hears which group of cells is next.
    pub fn run(&self, worker: &impl Worker<Job>, tell: &mut dyn FnMut(&str)) -> Vec<Cell> {
        let mut cells: Vec<Cell> = Vec::new();
        for &outline in &self.outlines {
            let area = outline.draw(self.effort.seed).area();
            for &load in &self.loads {
                for &angle in &self.angles {
                    tell(&format!("{outline}, area {load}, {angle} degrees"));
                    let goal = Goal {
                        angle,
                        area: load.bound(area),
                    };
                    let mut group = self.check_group(worker, outline, load, goal, area, &cells);
                    self.time(worker, &mut group);
                    cells.append(&mut group);
                }
            }
        }
        cells
    }

    fn check_group(
        &self,
        worker: &impl Worker<Job>,
        outline: Outline,
        load: Load,
        goal: Goal,
        area: f64,
        before: &[Cell],
    ) -> Vec<Cell> {
        let mut our_hash = None;
        let is_first = self.angles.first() == Some(&goal.angle);
        let meshers = self.meshers.iter().copied();
        let able = meshers.filter(|mesher| mesher.bounds_angles() || is_first);
        able.map(|mesher| {
            let job = self.job(mesher, outline, goal, true);
            let mesh = match timed_out_before(&job, before) {
                Some(limit) => Err(Fault::TimedOut(limit)),
                None => judge(worker.run(&job, self.effort.timeout), area, &mut our_hash),
            };
            Cell {
                outline,
                load,
                goal,
                mesher,
                mesh,
                runs: Vec::new(),
            }
        })
        .collect()
    }

    fn time(&self, worker: &impl Worker<Job>, group: &mut [Cell]) {
        self.effort.take_turns(group, |cell, run| {
            if cell.mesh.is_err() {
                return;
            }
            let job = self.job(cell.mesher, cell.outline, cell.goal, false);
            match worker.run(&job, self.effort.timeout) {
                Ok(answer) => cell.runs.extend(run.map(|_| answer.cost)),
                Err(fault) => cell.mesh = Err(fault),
            }
        });
    }

    fn job(&self, mesher: Mesher, outline: Outline, goal: Goal, check: bool) -> Job {
        Job {
            mesher,
            outline,
            seed: self.effort.seed,
            goal,
            check,
        }
    }
}

/// Returns the limit that the mesher exceeded on the same outline at an easier goal.
fn timed_out_before(job: &Job, before: &[Cell]) -> Option<Duration> {
    let easier = |goal: Goal| {
        let area = |goal: Goal| goal.area.unwrap_or(f64::INFINITY);
        goal.angle <= job.goal.angle && area(goal) >= area(job.goal)
    };
    before.iter().find_map(|cell| match cell.mesh {
        Err(Fault::TimedOut(limit))
            if (cell.mesher, cell.outline) == (job.mesher, job.outline) && easier(cell.goal) =>
        {
            Some(limit)
        }
        _ => None,
    })
}

/// Judges a checked answer: the mesh must cover the domain, and whoever names its set of triangles
/// must name the same one on any number of threads.
fn judge(
    answer: Result<Answer, Fault>,
    area: f64,
    our_hash: &mut Option<String>,
) -> Result<Quality, Fault> {
    let quality = answer?.quality;
    let quality = quality.ok_or_else(Fault::silence)?;
    if (quality.area - area).abs() > AREA_SLACK * area {
        let message = format!("{} instead of {area}", quality.area);
        return Err(Fault::failed("area", message));
    }
    agree(quality.hash.as_deref(), our_hash)?;
    Ok(quality)
}

#[cfg(test)]
mod tests;
