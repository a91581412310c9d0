//! Several files, one command: `delone mesh *.poly --out-dir meshes --to vtu`.
//!
//! What is to be done is settled before anything is: which files there are, under which names their results go, and
//! that none of these is in the way of another. Then each file is worked on as if it were the only one, several at
//! once; what is said about it is kept until all before it have been told. A file that fails stops nobody.
//!
//! - [`naming`]: names of outputs, and patterns of inputs;
//! - [`runner`]: the files are worked on;
//! - [`table`]: what has become of them, for people.

mod naming;
mod runner;
mod table;

use crate::exit::Failure;
use crate::files::{Outputs, place};
pub use naming::{Naming, expand};
pub use runner::{Results, Run};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// What help says about batches.
pub const HELP: &str = "\
Several files (also as a pattern, as in 'maps/*.poly'):
  --out-dir DIR puts their results there, under their own names, in the format of --to; or name outputs with {},
  which stands for the name of each: -o {}.vtu --picture {}.png. Without --out-dir results go beside the inputs.
  A file that fails stops no other; at the end a table says what has become of all. With --json each file that
  went well is one object on a line of standard output, which begins with file and outputs, the names written.";

/// Options about several files.
#[derive(clap::Args, Clone, Default)]
#[command(next_help_heading = "Several files")]
pub struct Batching {
    /// Folder for the results of several files; it is made if it is not there
    #[arg(long, value_name = "DIR")]
    pub out_dir: Option<PathBuf>,
    /// How many files are worked on at once; by default as many as the machine runs at once
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// A command that takes several files.
pub trait Many: Clone + Send + 'static {
    /// Returns the options about that.
    fn batching(&self) -> &Batching;

    /// Returns the inputs as they are named.
    fn inputs(&self) -> Vec<PathBuf>;

    /// Tells whether results are to be JSON.
    fn asks_json(&self) -> bool;

    /// Lists further files that the work on each reads.
    fn also_reads(&self) -> Vec<PathBuf> {
        Vec::new()
    }

    /// Returns the command for one of the files, whose outputs are named by `naming`.
    ///
    /// *Errors*: the names of outputs will not do for several files.
    fn for_one(&self, input: &Path, naming: &Naming<'_>) -> Result<Self, Failure>;

    /// Settles what is to be written, without a look at the input.
    fn settle(&self) -> Result<Outputs, Failure>;

    /// Makes results be told as JSON, and lets the work have so many threads if nobody has said how many.
    fn in_a_batch(&mut self, threads: usize);

    /// Works on the one file.
    fn run_alone(&self, quiet: bool) -> Result<(), Failure>;
}

/// Work on one file.
pub struct Unit {
    /// The input, as people know it.
    pub file: String,
    /// The places of all that is read.
    inputs: Vec<PathBuf>,
    outputs: Outputs,
    /// Works on so many threads, and prints results.
    work: Box<dyn FnOnce(usize) -> Result<(), Failure> + Send>,
}

impl Unit {
    /// Makes work on a file that writes none.
    pub fn reading(
        file: &Path,
        work: impl FnOnce() -> Result<(), Failure> + Send + 'static,
    ) -> Self {
        Self {
            file: file.display().to_string(),
            inputs: place(file).into_iter().collect(),
            outputs: Outputs::default(),
            work: Box::new(|_| work()),
        }
    }
}

/// What a command line comes to.
pub enum Plan<C> {
    /// Work as it always was.
    One(C),
    /// Work on several files, and the folder that was made for it.
    Many(Vec<Unit>, Option<Made>),
}

/// Runs a command, on one file or on many.
pub fn run<C: Many>(command: &C, quiet: bool) -> Result<(), Failure> {
    match plan(command)? {
        Plan::One(command) => command.run_alone(quiet),
        Plan::Many(units, made) => {
            made.into_iter().for_each(Made::keep);
            let run = Run {
                jobs: command.batching().jobs,
                results: Results::tabled(command.asks_json()),
                quiet,
            };
            run.all(units)
        }
    }
}

/// Settles what a command line comes to.
pub fn plan<C: Many>(command: &C) -> Result<Plan<C>, Failure> {
    let Batching { out_dir, jobs } = command.batching();
    let inputs = expand(&command.inputs())?;
    let naming = Naming {
        folder: out_dir.as_deref(),
        is_alone: inputs.len() == 1,
    };
    if out_dir.is_none() && inputs.len() < 2 {
        if jobs.is_some() {
            let idle = "--jobs is about several files, and there is but one";
            return Err(Failure::Usage(idle.to_owned()));
        }
        let one = inputs.first();
        let one = one.map(|input| command.for_one(input, &naming));
        return Ok(Plan::One(one.unwrap_or_else(|| Ok(command.clone()))?));
    }
    if inputs.is_empty() {
        let idle = "--out-dir is about files, and none is named";
        return Err(Failure::Usage(idle.to_owned()));
    }
    let made = out_dir.as_deref().map(Made::folder).transpose()?.flatten();
    let units = inputs
        .iter()
        .map(|input| unit(command.for_one(input, &naming)?, Some(input)))
        .collect::<Result<Vec<_>, _>>()?;
    require_apart(&units)?;
    Ok(Plan::Many(units, made))
}

/// Settles the work on one file.
pub fn unit<C: Many>(mut command: C, input: Option<&Path>) -> Result<Unit, Failure> {
    let file = input.map_or("sample lake".to_owned(), |path| path.display().to_string());
    if input == Some(Path::new("-")) {
        let clash = "`-`: of several inputs none can be standard input; name files";
        return Err(Failure::Usage(clash.to_owned()));
    }
    let outputs = command.settle()?;
    if outputs.use_stdout() {
        let clash = "standard output cannot hold the results of several files; `{}` in an output stands \
                     for the name of each";
        return Err(Failure::Usage(clash.to_owned()));
    }
    let more = command.also_reads();
    let all = input.into_iter().chain(more.iter().map(PathBuf::as_path));
    Ok(Unit {
        inputs: all.filter_map(place).collect(),
        file,
        outputs,
        work: Box::new(move |threads| {
            command.in_a_batch(threads);
            command.run_alone(true)
        }),
    })
}

/// Requires that no file is written twice, and that none is written that is read.
pub fn require_apart(units: &[Unit]) -> Result<(), Failure> {
    let inputs: BTreeSet<&Path> = units
        .iter()
        .flat_map(|u| &u.inputs)
        .map(PathBuf::as_path)
        .collect();
    let mut writers: BTreeMap<&Path, usize> = BTreeMap::new();
    for (i, unit) in units.iter().enumerate() {
        for (_, name, place) in unit.outputs.places() {
            let Some(place) = place else { continue };
            let name = name.display();
            if inputs.contains(place) {
                return Err(Failure::Usage(format!(
                    "{name} would be written for {}, but it is an input; name another folder with --out-dir",
                    unit.file
                )));
            }
            let first = *writers.entry(place).or_insert(i);
            if first != i {
                let [first, file] = [&units[first].file, &unit.file];
                return Err(Failure::Usage(format!(
                    "{name} would be written for both {first} and {file}; work on them one after the other, \
                     with another --out-dir each"
                )));
            }
        }
    }
    Ok(())
}

/// A folder that was made just now, and goes again if nothing comes of it.
pub struct Made(Option<PathBuf>);

impl Made {
    /// Makes a folder, unless it is there.
    fn folder(path: &Path) -> Result<Option<Self>, Failure> {
        if path.is_dir() {
            return Ok(None);
        }
        match std::fs::create_dir_all(path) {
            Ok(()) => Ok(Some(Self(Some(path.to_owned())))),
            Err(error) => Err(Failure::NotReached(format!(
                "cannot make the folder {}: {error}",
                path.display()
            ))),
        }
    }

    /// Lets it stay.
    pub fn keep(mut self) {
        self.0 = None;
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        if let Some(path) = &self.0 {
            // That it stays, empty, is no harm.
            drop(std::fs::remove_dir(path));
        }
    }
}
