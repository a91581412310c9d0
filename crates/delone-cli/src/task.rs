//! What the commands have in common that ask something of points: input, outputs and figures.

use crate::batch::Naming;
use crate::exit::Failure;
use crate::files::{self, Content, Input, Outputs, Reading, Writing};
use crate::job::{self, few};
use crate::memory::peak_rss_bytes;
use crate::numbering::Numbering;
use crate::phases::Phases;
use crate::progress::Progress;
use delone_io::{DomainData, PointSet};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Input, outputs, and how to get from one to the others.
// Options without heading say so, lest they come under that of whatever stands before them.
#[derive(clap::Args, Clone)]
pub struct Task {
    /// File of points, or `-` for standard input
    #[arg(value_name = "POINTS", help_heading = None)]
    input: PathBuf,
    /// File to write, in the format that its extension names, or `-`; repeatable
    #[arg(short, long, value_name = "OUT", help_heading = None)]
    pub output: Vec<PathBuf>,
    /// Picture to write, .svg or .png
    #[arg(short, long, value_name = "PIC", help_heading = None)]
    picture: Option<PathBuf>,
    /// Print one JSON object with figures, seconds and memory
    #[arg(long, help_heading = None)]
    pub json: bool,
    /// Number of threads; by default as many as the machine runs at once
    #[arg(short, long, value_name = "N", help_heading = None,
          value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    pub writing: Writing,
}

/// The figures of a run; the fields are the keys of `--json`, in this order.
#[derive(Serialize)]
struct Report<'a, T> {
    #[serde(flatten)]
    figures: &'a T,
    threads: usize,
    seconds: &'a Phases,
    peak_rss_bytes: Option<u64>,
}

impl Task {
    /// Returns the number of threads.
    pub fn threads(&self) -> usize {
        job::threads(self.threads)
    }

    /// Runs what has no setting for threads of its own on as many as were asked for.
    pub fn on_threads<T: Send>(
        &self,
        work: impl FnOnce() -> Result<T, delone::Error> + Send,
    ) -> Result<T, delone::Error> {
        delone::on_threads(self.threads(), work)?
    }

    /// Returns the input as it is named.
    pub fn input(&self) -> &Path {
        &self.input
    }

    /// Returns the task for one of several inputs, whose outputs are named by `naming`; `names_more` tells whether
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
            input: input.to_owned(),
            output,
            picture,
            ..self.clone()
        })
    }

    /// Makes results be told as JSON, and lets the work have so many threads if nobody has said how many.
    pub fn in_a_batch(&mut self, threads: usize) {
        self.json = true;
        self.threads = self.threads.or(Some(few(threads)));
    }

    /// Settles what is to be written: for each output what it holds, for the picture what it shows, and
    /// `more`.
    pub fn outputs(
        &self,
        content: impl Fn(&Path) -> Content,
        picture: Content,
        more: Option<(PathBuf, Content)>,
    ) -> Result<Outputs, Failure> {
        let outputs = self.output.iter().map(|o| (o.clone(), content(o)));
        let pictures = self.picture.iter().map(|p| (p.clone(), picture));
        let outputs = self.writing.outputs(outputs.chain(pictures).chain(more))?;
        outputs.leave_stdout_to(self.json)?;
        Ok(outputs)
    }

    /// Requires that a second file is not standard input, too.
    pub fn require_apart(&self, path: &Path) -> Result<(), Failure> {
        if path != Path::new("-") || self.input != path {
            return Ok(());
        }
        let clash = "standard input can be read but once; name a file for one of the inputs";
        Err(Failure::Usage(clash.to_owned()))
    }

    /// Reads the points, which no output may overwrite.
    pub fn points(
        &self,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<(PointSet, Numbering), Failure> {
        points_of(&self.reading.open(&self.input)?, outputs, progress)
    }

    /// Reads the points with what lies between them; no output may overwrite them.
    pub fn domain(
        &self,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<(DomainData, Numbering), Failure> {
        let input = self.reading.open(&self.input)?;
        outputs.spare(&input.files())?;
        let (domain, unused) = input.domain(progress)?;
        progress.note(&unused);
        let numbering = Numbering::of(&input.name(), &domain);
        Ok((domain, numbering))
    }

    /// Reads the points of a second file.
    pub fn more_points(
        &self,
        path: &Path,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<(PointSet, Numbering), Failure> {
        points_of(&self.open_another(path)?, outputs, progress)
    }

    /// Opens a second file, which has a format of its own.
    pub fn open_another(&self, path: &Path) -> Result<Input, Failure> {
        self.reading.of_another_file().open(path)
    }

    /// Tells the figures to programs or to people, with `lines` for the latter.
    pub fn report<T: Serialize>(
        &self,
        figures: &T,
        lines: &[String],
        phases: &Phases,
        written: &[PathBuf],
        quiet: bool,
    ) -> Result<(), Failure> {
        if self.json {
            let report = Report {
                figures,
                threads: self.threads(),
                seconds: phases,
                peak_rss_bytes: peak_rss_bytes(),
            };
            return files::print_json(&report);
        }
        if !quiet {
            phases.summarise(lines, written);
        }
        Ok(())
    }
}

fn points_of(
    input: &Input,
    outputs: &Outputs,
    progress: &Progress,
) -> Result<(PointSet, Numbering), Failure> {
    outputs.spare(&input.files())?;
    let (points, unused) = input.points(progress)?;
    progress.note(&unused);
    let numbering = Numbering::of_points(&input.name(), &points);
    Ok((points, numbering))
}
