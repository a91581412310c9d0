//! What is written and read, in which order: everybody writes a mesh, everybody reads what Delone has written.

use super::engine::Engine;
use super::job::{Answer, Deed, Job};
use crate::effort::Effort;
use crate::process::Fault;
use crate::python::Files;
use crate::workshop::Worker;
use std::path::{Path, PathBuf};

/// What to measure, and how carefully.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Who takes part, Delone first.
    pub engines: Vec<Engine>,
    /// The formats of meshes, by their endings.
    pub endings: Vec<String>,
    /// Number of points of the mesh.
    pub size: usize,
    /// Clouds of points to be read.
    pub clouds: Vec<PathBuf>,
    /// How carefully.
    pub effort: Effort,
}

/// Somebody's work on one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The format of a mesh, or the name of a cloud.
    pub name: String,
    /// Who.
    pub engine: Engine,
    /// Doing what.
    pub deed: Deed,
    /// Bytes of the file.
    pub bytes: u64,
    /// The runs that count, or what became of one.
    pub runs: Result<Vec<Answer>, Fault>,
}

impl Plan {
    /// Carries the plan out in a folder; `tell` hears which file is next.
    pub fn run(
        &self,
        worker: &impl Worker<Job>,
        folder: &Files,
        tell: &mut dyn FnMut(&str),
    ) -> Vec<Cell> {
        let mut cells = Vec::new();
        if !self.endings.is_empty() && self.engines.len() > 1 {
            // What others write they take from these arrays.
            let given = self.job(Engine::Delone, Deed::Write, folder.place("mesh.npy"));
            if let Err(fault) = worker.run(&given, self.effort.timeout) {
                tell(&format!("no mesh: {}", fault.in_short()));
            }
        }
        for ending in &self.endings {
            tell(ending);
            let able = |e: &Engine| e.knows_mesh(ending);
            let engines: Vec<_> = self.engines.iter().copied().filter(able).collect();
            let ours = folder.place(&format!("mesh.{ending}"));
            for deed in [Deed::Write, Deed::Read] {
                let jobs = engines.iter().map(|&engine| match (deed, engine) {
                    (Deed::Write, Engine::Meshio) => {
                        self.job(engine, deed, folder.place(&format!("theirs.{ending}")))
                    }
                    _ => self.job(engine, deed, ours.clone()),
                });
                cells.extend(self.time(worker, ending, jobs.collect()));
            }
            for name in ["mesh", "theirs"] {
                // The arrays are still needed. What stays for other reasons goes with the folder.
                if ending != "npy" {
                    let _ = std::fs::remove_file(folder.place(&format!("{name}.{ending}")));
                }
            }
        }
        for cloud in &self.clouds {
            let name = cloud.display().to_string();
            tell(&name);
            let able = self.engines.iter().filter(|e| e.knows_clouds());
            let jobs = able.map(|&engine| self.job(engine, Deed::Points, cloud.clone()));
            cells.extend(self.time(worker, &name, jobs.collect()));
        }
        cells
    }

    /// Lets all do their jobs in turns. Who finds another number of points or triangles than the first has failed.
    fn time(&self, worker: &impl Worker<Job>, name: &str, jobs: Vec<Job>) -> Vec<Cell> {
        let begin = |job: Job| {
            let cell = Cell {
                name: name.to_owned(),
                engine: job.engine,
                deed: job.deed,
                bytes: 0,
                runs: Ok(Vec::new()),
            };
            (job, cell)
        };
        let mut group: Vec<_> = jobs.into_iter().map(begin).collect();
        let mut counted = None;
        self.effort.take_turns(&mut group, |(job, cell), run| {
            let Ok(runs) = &mut cell.runs else { return };
            match worker.run(job, self.effort.timeout) {
                Ok(answer) => {
                    cell.bytes = length(&job.file);
                    let found = (answer.points, answer.triangles);
                    if *counted.get_or_insert(found) == found {
                        runs.extend(run.map(|_| answer));
                    } else {
                        let (points, triangles) = found;
                        let message = format!("{points} points, {triangles} triangles");
                        cell.runs = Err(Fault::failed("other numbers", message));
                    }
                }
                Err(fault) => cell.runs = Err(fault),
            }
        });
        group.into_iter().map(|(_, cell)| cell).collect()
    }

    fn job(&self, engine: Engine, deed: Deed, file: PathBuf) -> Job {
        Job {
            engine,
            deed,
            file,
            size: self.size,
            seed: self.effort.seed,
        }
    }
}

fn length(path: &Path) -> u64 {
    std::fs::metadata(path).map_or(0, |file| file.len())
}

#[cfg(test)]
mod tests {
    use super::super::report::tests::{answer, plan};
    use super::{Deed, Engine, Fault, Files, Job};
    use crate::workshop::Actor;
    use std::cell::RefCell;

    #[test]
    fn everybody_takes_turns_and_who_counts_otherwise_has_failed() {
        let actor = Actor {
            answer: |job: &Job| {
                let lost = (job.engine, job.deed) == (Engine::Meshio, Deed::Read);
                Ok(answer(if lost { 99 } else { 100 }, 1e-3))
            },
            asked: RefCell::default(),
        };
        let cells = plan().run(&actor, &Files::new().unwrap(), &mut |_| {});
        let told: Vec<_> = cells
            .iter()
            .map(|c| {
                (
                    &*c.name,
                    c.engine,
                    c.deed,
                    c.runs.as_ref().ok().map(Vec::len),
                )
            })
            .collect();
        let [delone, meshio, laspy] = Engine::ALL;
        let expected = [
            ("vtu", delone, Deed::Write, Some(2)),
            ("vtu", meshio, Deed::Write, Some(2)),
            ("vtu", delone, Deed::Read, Some(2)),
            ("vtu", meshio, Deed::Read, None),
            ("npy", delone, Deed::Write, Some(2)),
            ("npy", delone, Deed::Read, Some(2)),
            ("cloud.laz", delone, Deed::Points, Some(2)),
            ("cloud.laz", laspy, Deed::Points, Some(2)),
        ];
        assert_eq!(told, expected);
        let Err(Fault::Failed { how, .. }) = &cells[3].runs else {
            panic!("it found 99 points");
        };
        assert_eq!(how, "other numbers");
        let first = actor.asked.into_inner().swap_remove(0);
        assert!(first.file.ends_with("mesh.npy"));
    }
}
