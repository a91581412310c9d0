//! Which cells are checked and timed, in which order.
//!
//! For every outline, load and angle: each mesher's result is checked in a process of its own, then
//! those that did not fail are timed in turns (warm-up rounds, then rounds that count). A mesher that
//! took too long on an outline is not tried there at a harder goal. One that cannot be asked for an
//! angle runs at the first angle only.

use super::goal::{Goal, Load, Outline};
use super::job::{Answer, Job};
use super::mesher::Mesher;
use super::python::Python;
use super::quality::Quality;
use crate::measure::Cost;
use crate::plan::agree;
use crate::process::{Fault, Launcher};
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
    /// Seed of the outlines.
    pub seed: u64,
    /// Rounds that are discarded.
    pub warmups: usize,
    /// Rounds that count.
    pub runs: usize,
    /// Longest time for one mesh, with the making of its input.
    pub timeout: Duration,
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

/// Does a job, wherever and however.
pub trait Worker {
    /// Runs `job`, for no longer than `timeout`.
    ///
    /// # Errors
    /// What became of it, if it does not answer.
    fn mesh(&self, job: &Job, timeout: Duration) -> Result<Answer, Fault>;
}

/// Runs jobs in children of this program, and in Python.
#[derive(Debug)]
pub struct Workshop {
    /// Runs this program.
    pub launcher: Launcher,
    /// Runs the script, if there is a Python.
    pub python: Option<Python>,
}

impl Worker for Workshop {
    fn mesh(&self, job: &Job, timeout: Duration) -> Result<Answer, Fault> {
        match &self.python {
            Some(python) if job.mesher.python_package().is_some() => python.mesh(job, timeout),
            _ => self.launcher.answer(&job.to_args(), timeout),
        }
    }
}

impl Plan {
    /// Carries the plan out; `tell` hears which group of cells is next.
    pub fn run(&self, worker: &impl Worker, tell: &mut dyn FnMut(&str)) -> Vec<Cell> {
        let mut cells: Vec<Cell> = Vec::new();
        for &outline in &self.outlines {
            let area = outline.draw(self.seed).area();
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
        worker: &impl Worker,
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
                None => judge(worker.mesh(&job, self.timeout), area, &mut our_hash),
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

    /// Lets the meshers take turns, so that a slow minute of the machine hits all of them.
    fn time(&self, worker: &impl Worker, group: &mut [Cell]) {
        for round in 0..self.warmups + self.runs {
            for cell in group.iter_mut().filter(|cell| cell.mesh.is_ok()) {
                let job = self.job(cell.mesher, cell.outline, cell.goal, false);
                match worker.mesh(&job, self.timeout) {
                    Ok(answer) if round >= self.warmups => cell.runs.push(answer.cost),
                    Ok(_) => (),
                    Err(fault) => cell.mesh = Err(fault),
                }
            }
        }
    }

    fn job(&self, mesher: Mesher, outline: Outline, goal: Goal, check: bool) -> Job {
        Job {
            mesher,
            outline,
            seed: self.seed,
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
