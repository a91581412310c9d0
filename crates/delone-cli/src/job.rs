//! What every command does that makes a mesh: from an input, or the sample, to outputs and figures.

mod build;
mod certify;
mod report;

use crate::batch::{Batching, Naming};
use crate::exit::Failure;
use crate::files::{Content, Input, Outputs, Reading, Writing};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::refinable::Refinable;
use crate::sample::scene_data;
pub use build::{Building, Built, Laps, refine};
pub use certify::{Certify, Made, OfMesh, Subject, proof_failure, rule_word};
use delone_io::DomainData;
use delone_samples::Scene;
pub use report::{Figures, Report};
use std::path::{Path, PathBuf};

/// What is taken if nothing is named.
const SAMPLE: Scene = Scene::Lake;

/// Input and outputs, and how to get from one to the others.
// Options without heading say so, lest they come under that of whatever stands before them.
#[derive(clap::Args, Clone)]
pub struct Job {
    /// Files of points or of domains, `-` for standard input, or patterns as in 'maps/*.poly'
    #[arg(value_name = "INPUT", help_heading = None)]
    inputs: Vec<PathBuf>,
    /// Mesh to write: .node/.ele (a family of files), .npy, .vtu, .geojson, .svg, .png, or `-`;
    /// repeatable
    #[arg(short, long, value_name = "OUT", help_heading = None)]
    output: Vec<PathBuf>,
    /// Picture to write, .svg or .png, coloured by the quality of the triangles, with segments and regions
    #[arg(short, long, value_name = "PIC", help_heading = None)]
    picture: Option<PathBuf>,
    /// Print one JSON object with counts, hash, seconds and memory
    #[arg(long, help_heading = None)]
    pub json: bool,
    /// Number of threads; by default as many as the machine runs at once
    #[arg(short, long, value_name = "N", help_heading = None,
          value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    pub building: Building,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    pub writing: Writing,
    #[command(flatten)]
    pub batching: Batching,
    #[command(flatten)]
    certify: Certify,
}

impl Job {
    /// Returns the number of threads.
    pub fn threads(&self) -> usize {
        threads(self.threads)
    }

    /// Returns the inputs as they are named.
    pub fn inputs(&self) -> Vec<PathBuf> {
        self.inputs.clone()
    }

    /// Returns the job for one of its inputs, whose outputs are named by `naming`; `names_more` tells whether
    /// the command names outputs of its own.
    pub fn for_one(
        &self,
        input: &Path,
        naming: &Naming<'_>,
        names_more: bool,
    ) -> Result<Self, Failure> {
        let (output, picture) = naming.outputs(
            input,
            (&self.output, self.picture.as_deref()),
            self.writing.to(),
            names_more,
        )?;
        Ok(Self {
            inputs: vec![input.to_owned()],
            output,
            picture,
            certify: self.certify.for_one(input, naming)?,
            ..self.clone()
        })
    }

    /// Makes results be told as JSON, and lets the work have so many threads if nobody has said how many.
    pub fn in_a_batch(&mut self, threads: usize) {
        self.json = true;
        self.threads = self.threads.or(Some(few(threads)));
    }

    /// Reads points or a domain, which no output may overwrite.
    pub fn read(
        &self,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<(DomainData, Numbering), Failure> {
        let (name, domain) = match self.open(outputs)? {
            Some(input) => (input.name(), noted(input.domain(progress)?, progress)),
            None => (SAMPLE.name().to_owned(), scene_data(SAMPLE)),
        };
        let numbering = Numbering::of(&name, &domain);
        Ok((domain, numbering))
    }

    /// Reads a domain or a mesh, with its `.area` file if `takes_areas`; no output may overwrite it.
    pub fn read_refinable(
        &self,
        outputs: &Outputs,
        takes_areas: bool,
        progress: &Progress,
    ) -> Result<(Refinable, Numbering), Failure> {
        let (name, refinable) = match self.open(outputs)? {
            Some(input) => {
                let read = input.refinable(takes_areas, progress)?;
                (input.name(), noted(read, progress))
            }
            None => (SAMPLE.name().to_owned(), scene_data(SAMPLE).into()),
        };
        let numbering = Numbering::of(&name, &refinable.domain);
        Ok((refinable, numbering))
    }

    /// Opens the input, if one is named.
    fn open(&self, outputs: &Outputs) -> Result<Option<Input>, Failure> {
        match self.inputs.first() {
            Some(path) => {
                let input = self.reading.open(path)?;
                outputs.spare(&input.files())?;
                Ok(Some(input))
            }
            None if self.reading.is_given() => {
                let lacking = "--from and --columns are about INPUT, and none is named";
                Err(Failure::Usage(lacking.to_owned()))
            }
            None => Ok(None),
        }
    }

    /// Settles what is to be written, outputs with such a `mesh` and the report pages named; if nothing at all was
    /// asked for, that is mesh and picture of the sample, and of a command that makes `reports` also
    /// that page.
    pub fn outputs(&self, mesh: Content, reports: Option<&[PathBuf]>) -> Result<Outputs, Failure> {
        let meshes = self.output.iter().map(|o| (o.clone(), mesh));
        let pictures = self.picture.iter().map(|p| (p.clone(), Content::Picture));
        let pages = reports.into_iter().flatten();
        let pages = pages.map(|page| (page.clone(), Content::Report));
        let mut asked = self.writing.outputs(meshes.chain(pictures).chain(pages))?;
        self.certify.settle(&mut asked)?;
        asked.leave_stdout_to(self.json)?;
        if asked.is_empty() && self.demonstrates() {
            return self.demonstration(mesh, reports.is_some());
        }
        Ok(asked)
    }

    /// Tells whether no input, output or figure was asked for: somebody tries the program.
    pub fn demonstrates(&self) -> bool {
        let asks = self.json || self.picture.is_some() || !self.output.is_empty();
        self.inputs.is_empty() && !asks
    }

    /// What is left in the current folder then.
    fn demonstration(&self, mesh: Content, makes_report: bool) -> Result<Outputs, Failure> {
        let named = |extension: &str| Path::new(SAMPLE.name()).with_extension(extension);
        let mut wanted = vec![(named("ele"), mesh), (named("png"), Content::Picture)];
        if makes_report {
            wanted.push((named("html"), Content::Report));
        }
        self.writing.outputs(wanted)
    }
}

/// Counts threads as options do.
pub fn few(threads: usize) -> u16 {
    u16::try_from(threads).unwrap_or(u16::MAX)
}

/// Returns the number of threads: as many as asked for, otherwise as the machine runs at once.
pub fn threads(asked: Option<u16>) -> usize {
    match asked {
        Some(n) => n.into(),
        None => std::thread::available_parallelism().map_or(1, usize::from),
    }
}

/// Takes what was read, and says what of it is left unused.
fn noted<T>((read, unused): (T, Vec<String>), progress: &Progress) -> T {
    progress.note(&unused);
    read
}
