//! What one child process is asked to write or read, and what it answers.

use super::engine::Engine;
use crate::measure::{Cost, under_the_clock};
use crate::peer::Peer;
use crate::python::Files;
use crate::workshop::Errand;
use delone::Delaunay;
use delone_io::{MeshView, ReadOptions, Source, Target, WriteOptions};
use delone_samples::Distribution;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io;
use std::path::PathBuf;

/// The name of the subcommand that runs a job.
pub const SUBCOMMAND: &str = "file-job";

/// What is done with a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Deed {
    /// A mesh is written to it.
    Write,
    /// A mesh is read from it.
    Read,
    /// Points are read from it.
    Points,
}

impl fmt::Display for Deed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Write => "write",
            Self::Read => "read",
            Self::Points => "points",
        })
    }
}

/// One file, once.
#[derive(Clone, Debug, PartialEq, clap::Args)]
pub struct Job {
    /// Who does it
    #[arg(long)]
    pub engine: Engine,
    /// What is done
    #[arg(long)]
    pub deed: Deed,
    /// The file; its ending is the format
    #[arg(long)]
    pub file: PathBuf,
    /// Number of points of a mesh that is written
    #[arg(long)]
    pub size: usize,
    /// Their seed
    #[arg(long)]
    pub seed: u64,
}

/// What a job found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// What it took.
    #[serde(flatten)]
    pub cost: Cost,
    /// How many points were written or read.
    pub points: usize,
    /// How many triangles.
    pub triangles: usize,
}

impl Errand for Job {
    type Answer = Answer;

    fn to_args(&self) -> Vec<String> {
        let options = [
            ("--engine", self.engine.to_string()),
            ("--deed", self.deed.to_string()),
            ("--file", self.file.display().to_string()),
            ("--size", self.size.to_string()),
            ("--seed", self.seed.to_string()),
        ];
        let options = options.map(|(option, value)| [option.to_owned(), value]);
        [SUBCOMMAND.to_owned()]
            .into_iter()
            .chain(options.into_iter().flatten())
            .collect()
    }

    fn to_words(&self, _: &Files) -> Option<io::Result<Vec<String>>> {
        self.engine.python_package()?;
        Some(Ok(
            [self.deed.to_string(), self.file.display().to_string()].to_vec()
        ))
    }
}

impl Job {
    /// Does the job in this process.
    ///
    /// # Errors
    /// What the writer or the reader says.
    pub fn run(self) -> Result<Answer, String> {
        match self.deed {
            Deed::Write => self.write(),
            Deed::Read => self.read(),
            Deed::Points => self.points(),
        }
        .map_err(|error| error.to_string())
    }

    fn write(&self) -> Result<Answer, Box<dyn std::error::Error>> {
        let points = Distribution::Uniform.points(self.size, self.seed);
        let mesh = Delaunay::new().triangulate(points)?;
        let target = Target::from_arg(&self.file, None);
        let options = WriteOptions::default();
        let (written, cost) = under_the_clock(|| {
            delone_io::write_mesh(&[target], &MeshView::from(&mesh), &options, &())
        });
        written?;
        Ok(Answer {
            cost,
            points: mesh.points().len(),
            triangles: mesh.triangles().len(),
        })
    }

    fn read(&self) -> Result<Answer, Box<dyn std::error::Error>> {
        let source = Source::from_arg(&self.file);
        let (mesh, cost) =
            under_the_clock(|| delone_io::read_mesh(&source, &ReadOptions::default(), &()));
        let mesh = mesh?;
        Ok(Answer {
            cost,
            points: mesh.vertices.points.len(),
            triangles: mesh.triangles.len(),
        })
    }

    fn points(&self) -> Result<Answer, Box<dyn std::error::Error>> {
        let source = Source::from_arg(&self.file);
        let (set, cost) =
            under_the_clock(|| delone_io::read_points(&source, &ReadOptions::default(), &()));
        Ok(Answer {
            cost,
            points: set?.points.len(),
            triangles: 0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Deed, Engine, Errand, Job, SUBCOMMAND};
    use clap::Parser;

    #[derive(clap::Parser)]
    struct CommandLine {
        #[command(flatten)]
        job: Job,
    }

    #[test]
    fn what_is_written_is_read_again() {
        let folder = std::env::temp_dir().join(format!("delone-files-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let job = |deed| Job {
            engine: Engine::Delone,
            deed,
            file: folder.join("mesh.ply"),
            size: 1000,
            seed: 3,
        };
        let args = job(Deed::Write).to_args();
        assert_eq!(args[0], SUBCOMMAND);
        assert_eq!(CommandLine::parse_from(args).job, job(Deed::Write));
        let written = job(Deed::Write).run().unwrap();
        let read = job(Deed::Read).run().unwrap();
        let points = job(Deed::Points).run().unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
        assert_eq!((written.points, written.triangles > 1900), (1000, true));
        assert_eq!((read.points, read.triangles), (1000, written.triangles));
        assert_eq!(points.points, 1000);
    }
}
