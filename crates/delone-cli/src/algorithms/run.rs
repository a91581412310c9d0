//! `delone algorithms run`: one algorithm, its figures, its log, its animation.

use super::figures::Figures;
use super::given::Given;
use super::named;
use super::watched::Watched;
use crate::exit::Failure;
use crate::files::{self, Content, Outputs, Writing};
use crate::memory::peak_rss_bytes;
use crate::phases::Phases;
use crate::progress::Progress;
use delone::classic::{Algorithm, Input, Output};
use delone::{Log, Observer, Step, Tally};
use delone_io::{Constraints, MeshView, Recording};
use serde::Serialize;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  delone algorithms run incremental                   thirty points, counted
  delone algorithms run sweep points.csv --svg sweep.svg --filmstrip sweep.png
  delone algorithms run edge-flip mesh.ele -o flipped.ele   from a given triangulation
  delone algorithms run thesis outline.poly --max-edge 0.5 --min-angle 20 --gif thesis.gif
  delone algorithms run random-incremental points.csv --seed 7 --json | jq .statistics.flips
  delone algorithms run cline-renka points.csv --log run.json   every step, for another program";

const JSON: &str = "\
The JSON object of --json:
  algorithm        its name
  points, duplicates, vertices_added
                   what was read; points merged into an equal one; vertices that refinement has added
  triangles, constrained_edges
                   of the result
  hull             of `convex-hull`: the vertices on it, from 0
  hash             names the set of triangles: 32 hexadecimal digits, the same on every machine
  is_canonical     whether every triangle is one of the canonical (constrained) Delaunay triangulation of
                   its vertices
  failures         of `printed-sweep`: where it goes wrong, objects of kind (sees-nothing, sees-one,
                   sees-several-runs, segment-lost, overlaps) and vertices, from 0
  statistics       orientation_tests, circle_tests, ties among these, flips, walk_steps, pushed (things
                   that waited), edges_created, edges_deleted (flips not counted), first_conflicts,
                   last_conflicts (Φ: pairs of a triangle and a point in its circle; null where nobody
                   counts), steps (events told)
  seconds          wall time of the phases read, run (not observed), observe, check, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Points beyond which conflicts are not counted: each count takes linear time.
const MOST_CONFLICTS: usize = 5000;

/// Run a classical algorithm, count what it does, and show it
///
/// It runs twice: once unobserved, which is timed, and once observed.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Run {
    /// Which; `delone algorithms` lists them
    #[arg(value_name = "NAME", value_parser = named(), hide_possible_values = true)]
    algorithm: Algorithm,
    #[command(flatten)]
    given: Given,
    /// Mesh to write, in the format that the extension names, or `-`; repeatable
    #[arg(short, long, value_name = "OUT", help_heading = None)]
    output: Vec<PathBuf>,
    /// Picture of the result to write, .svg or .png
    #[arg(short, long, value_name = "PIC", help_heading = None)]
    picture: Option<PathBuf>,
    /// Print one JSON object with figures, hash, seconds and memory
    #[arg(long, help_heading = None)]
    json: bool,
    #[command(flatten)]
    watched: Watched,
    #[command(flatten)]
    writing: Writing,
}

/// The figures of a run, for programs.
#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    figures: &'a Figures,
    seconds: &'a Phases,
    peak_rss_bytes: Option<u64>,
}

impl Run {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let outputs = self.outputs()?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let read = || self.given.read(self.algorithm, &outputs, &progress);
        let (input, numbering) = phases.time("read", read)?;
        let refused = |error| numbering.failure(error);

        let output = phases.time("run", || self.algorithm.run(&input).map_err(refused))?;
        let (tally, log) = phases.time("observe", || self.observe(&input, &progress, refused))?;
        let about = self.algorithm.about();
        let given = input.pslg.points.len();
        let figures = phases.time("check", || {
            Figures::of(about, given, &output, &tally, &progress).map_err(refused)
        })?;
        let written = phases.write(|| {
            let mut written = self.write(&outputs, &output, &progress)?;
            if let Some(log) = log {
                let recording = Recording::new(about, log);
                let size = self.writing.size();
                written.extend(self.watched.write(&recording, size, &progress)?);
            }
            Ok(written)
        })?;
        progress.finish();
        self.report(&figures, &phases, &written, quiet)
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        let meshes = self.output.iter().map(|o| (o.clone(), Content::Mesh));
        let pictures = self.picture.iter().map(|p| (p.clone(), Content::Picture));
        let mut outputs = self.writing.outputs(meshes.chain(pictures))?;
        self.watched.settle(self.writing.size(), &mut outputs)?;
        outputs.leave_stdout_to(self.json)?;
        Ok(outputs)
    }

    /// Runs it again, counts, and keeps every step if that is wanted.
    fn observe(
        &self,
        input: &Input,
        progress: &Progress,
        refused: impl Fn(delone::Error) -> Failure,
    ) -> Result<(Tally, Option<Log>), Failure> {
        let mut tally = Tally::default();
        let is_small = input.pslg.points.len() <= MOST_CONFLICTS;
        self.algorithm
            .observe(input, &mut (&mut tally, Conflicts(is_small)))
            .map_err(&refused)?;
        if !self.watched.is_wanted() {
            return Ok((tally, None));
        }
        self.watched.require_room(tally.steps, progress)?;
        let mut log = Log::new(self.algorithm.about().name, input.pslg.points.clone());
        self.algorithm.observe(input, &mut log).map_err(refused)?;
        Ok((tally, Some(log)))
    }

    fn write(
        &self,
        outputs: &Outputs,
        output: &Output,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        if outputs.is_empty() {
            return Ok(Vec::new());
        }
        let constraints = Constraints {
            edges: output.constrained.clone(),
            ..Constraints::default()
        };
        let mesh = MeshView::new(&output.points, &output.triangles);
        let mesh = match output.constrained[..] {
            [] => mesh,
            _ => mesh.with_constraints(&constraints),
        };
        self.writing.mesh(outputs, &mesh, progress)
    }

    fn report(
        &self,
        figures: &Figures,
        phases: &Phases,
        written: &[PathBuf],
        quiet: bool,
    ) -> Result<(), Failure> {
        if self.json {
            let report = Report {
                figures,
                seconds: phases,
                peak_rss_bytes: peak_rss_bytes(),
            };
            return files::print_json(&report);
        }
        if !quiet {
            phases.summarise(&figures.lines(), written);
        }
        Ok(())
    }
}

/// Wants conflicts to be counted, or not, and keeps nothing.
struct Conflicts(bool);

impl Observer for Conflicts {
    fn observe(&mut self, _: Step) {}

    fn wants_conflicts(&self) -> bool {
        self.0
    }
}
