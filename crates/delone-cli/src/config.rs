//! `delone run`: jobs that a file describes, so that they can be done again.
//!
//! A job is turned into the command line that would do the same, and that is parsed: keys are the long options, and
//! values mean what they mean there, always. All jobs are settled before the first begins.
//!
//! - [`document`]: the file;
//! - [`arguments`]: from keys and values to a command line.

mod arguments;
mod document;

use crate::batch::{self, Made, Many, Plan, Results, Run, Unit};
use crate::cli::{Cli, Command};
use crate::exit::Failure;
use crate::files;
use crate::words::shell_line;
use document::{Document, Section};
use std::io::Read;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone run job.toml                        all jobs of the file, several at once
  delone run job.toml --dry-run              only says which commands they stand for
  delone run job.toml --json                 one JSON object for each file that went well

A file of jobs:
  [defaults]                    # for every job that knows these options
  min-angle = 30
  out-dir = \"meshes\"
  to = \"vtu\"

  [[job]]                       # delone mesh lake.poly --min-angle=30 … --max-edge=0.05
  input = \"lake.poly\"
  max-edge = 0.05

  [[job]]
  command = \"triangulate\"       # or mesh, which it is if nothing is said, convert or cover
  input = [\"maps/*.geojson\", \"coast.poly\"]
  crossings = \"split\"
  picture = \"{}.png\"            # {} stands for the name of each input

  [[job]]                       # delone cover … --data-per-triangle=6 … -- surveys/*.csv
  command = \"cover\"
  input = \"surveys/*.csv\"
  data-per-triangle = 6
  data-out = \"{}-held.csv\"

Keys are the long options of the command; true is a flag that is given, a list an option that is given
several times. Of convert, output is the second argument. Paths begin at the folder of the file. Jobs may not
write what another writes or reads.";

const JSON: &str = "\
The JSON objects of --json are those of the commands, and begin with file and outputs, as of batches.";

/// Do the jobs that a file describes: meshes that are made again and again
///
/// The file is TOML: [defaults] and any number of [[job]], with the long options of `delone mesh`, `delone
/// triangulate`, `delone convert` and `delone cover` as keys. A job that fails stops no other; at the end a table says
/// what has become of all.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct RunFile {
    /// File of jobs, .toml, or `-` for standard input
    file: PathBuf,
    /// Only print the commands that the jobs stand for, one on a line
    #[arg(long)]
    dry_run: bool,
    /// How many files are worked on at once; by default as many as the machine runs at once
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    /// Print one JSON object for each file that went well, each on its own line
    #[arg(long)]
    json: bool,
}

impl RunFile {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let name = match self.file.as_path() {
            path if path == Path::new("-") => "-".to_owned(),
            path => path.display().to_string(),
        };
        let text = self.text(&name)?;
        let document = Document::parse(&name, &text)?;
        let lines = document.jobs().map(|job| arguments::of(&document, job));
        let lines = lines.collect::<Result<Vec<_>, _>>()?;
        if self.dry_run {
            return lines
                .iter()
                .try_for_each(|line| files::print(&shell_line(line)));
        }
        // Paths of the file begin where it lies, those within options too, such as sizes.
        enter_folder_of(&self.file)?;
        let (mut units, mut made) = (Vec::new(), Vec::new());
        for (job, line) in document.jobs().zip(lines) {
            let settled = self
                .settle(line)
                .map_err(|failure| document.blame(job, failure));
            let (more, folder) = settled?;
            units.extend(more);
            made.extend(folder);
        }
        batch::require_apart(&units)?;
        made.into_iter().for_each(Made::keep);
        Run {
            jobs: self.jobs,
            results: Results::tabled(self.json),
            quiet,
        }
        .all(units)
    }

    fn text(&self, name: &str) -> Result<String, Failure> {
        let mut bytes = Vec::new();
        let read = match name {
            "-" => std::io::stdin().lock().read_to_end(&mut bytes).map(drop),
            _ => std::fs::read(&self.file).map(|read| bytes = read),
        };
        read.map_err(|error| Failure::BadInput(format!("cannot read {name}: {error}")))?;
        String::from_utf8(bytes).map_err(|error| {
            let line = 1 + error.as_bytes()[..error.utf8_error().valid_up_to()]
                .iter()
                .filter(|&&byte| byte == b'\n')
                .count();
            Failure::BadInput(format!("{name}:{line}: this is not UTF-8"))
        })
    }

    /// Parses a command line, and settles its work.
    fn settle(&self, line: Vec<std::ffi::OsString>) -> Result<Settled, Failure> {
        let cli = <Cli as clap::Parser>::try_parse_from(line);
        let cli = cli.map_err(|error| Failure::Usage(in_words(&error)))?;
        match cli.asked() {
            Command::Mesh(command) => units(command),
            Command::Triangulate(command) => units(command),
            Command::Convert(command) => units(command),
            Command::Cover(command) => units(command),
            _ => unreachable!("bug: a job of another command"),
        }
    }
}

/// Takes the sentence from what the parser of command lines says, and leaves out its advice on usage.
pub fn in_words(error: &clap::Error) -> String {
    let text = error.to_string();
    let lines = text.lines().map(str::trim);
    let lines =
        lines.take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"));
    let words: Vec<&str> = lines.filter(|line| !line.is_empty()).collect();
    words.join("; ").trim_start_matches("error: ").to_owned()
}

/// The work of a job, and the folder that was made for it.
type Settled = (Vec<Unit>, Option<Made>);

fn units<C: Many>(command: &C) -> Result<Settled, Failure> {
    match batch::plan(command)? {
        Plan::Many(units, made) => Ok((units, made)),
        Plan::One(command) => {
            let input = command.inputs().into_iter().next();
            Ok((vec![batch::unit(command, input.as_deref())?], None))
        }
    }
}

fn enter_folder_of(file: &Path) -> Result<(), Failure> {
    let folder = file.parent().filter(|f| !f.as_os_str().is_empty());
    let entered = folder.map_or(Ok(()), std::env::set_current_dir);
    entered.map_err(|error| {
        let folder = folder.unwrap_or(file).display();
        Failure::BadInput(format!("cannot enter {folder}: {error}"))
    })
}

impl Document<'_> {
    /// Says which job it is that fails, and where it stands: at the key that the words name first, if they do.
    fn blame(&self, job: &Section<'_>, failure: Failure) -> Failure {
        match failure {
            Failure::Usage(text) => {
                let place = |(key, line)| Some((text.find(&format!("--{key}"))?, line));
                let first = job.keys().filter_map(place).min();
                let line = first.map_or(job.line, |(_, line)| line);
                Failure::Usage(format!("{}:{line}: {text}", self.name))
            }
            other => other,
        }
    }
}
