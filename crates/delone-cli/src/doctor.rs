//! `delone doctor`: what is wrong with a drawing, exactly, and its repair.

mod describe;
mod meaning;
mod mended;
mod report;

use crate::exit::Failure;
use crate::files::{self, Content, Input, Outputs, Reading, Writing};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::timing::timed;
use delone::doctor::{Diagnosis, Doctor as Examiner, Severity};
use delone::{DomainRule, Pslg};
use delone_io::{DomainData, Format, TroublesView};
use describe::Describer;
use mended::Mended;
use report::Report;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone doctor map.poly                           what is wrong, as far as ten of each kind
  delone doctor map.geojson --picture sick.svg     and where, on a picture
  delone doctor map.poly --tolerance 0.01          near misses, too: what is at most that far apart
  delone doctor map.poly --tolerance 0.01 --repair clean.poly
  delone doctor *.wkt --json | jq -c '[.file, .errors, .warnings]'";

const JSON: &str = "\
The JSON object of --json (numbers of points, segments and so on are those of the file, from base):
  file, base       the file, and the number of its first point
  points, segments counts of what the file holds
  tolerance        what --tolerance says
  healthy          whether there are neither errors nor warnings
  errors, warnings, notes
                   how many there are, all kinds together
  suggestion       a tolerance that closes the gaps that look like mistakes; null if there are none
  sharpest, corners_below_60
                   the smallest angle between neighbouring segments in degrees (null without corners), and
                   how many are below 60°: no triangle in such a corner can have its angles above that
  domain_known     whether it was asked what the segments enclose; not if they meet ten times as often as
                   there are segments
  troubles         an object for each kind, the worst first: kind, severity, total, and listed: number (as on
                   the picture), text, points, segments, polygon, seeds, at, to, size
  repair           null without --repair, else: file, points, segments, rounds, settled; moved (total,
                   largest, listed: point, from, at, distance), merged (point, into), split (segment, at,
                   distance), cuts (segments, at), vanished and doubled (segments), closed (unclosed rings
                   that are closed now); left, the kinds of trouble that the result still has, and healthy
  seconds          wall time of the phases read, examine, repair and write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)
Of what is listed, there are as many as --limit says.";

/// Say what is wrong with points and segments, exactly, and repair it
///
/// Errors are what `delone triangulate` refuses, at least unless it splits crossings; warnings, what has a
/// result, but perhaps not the one that was meant; notes are good to know. There is no hidden tolerance: near
/// misses are looked for with --tolerance alone, and compared with it exactly.
///
/// The exit code is 0 if there are neither errors nor warnings, else 5; with --repair, that is about the
/// repaired drawing.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Doctor {
    /// Files of points or domains, or `-` for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// What is at most so far apart is a near miss, in units of the coordinates
    #[arg(short, long, value_name = "LENGTH", default_value_t = 0.0)]
    tolerance: f64,
    /// How many of each kind of trouble are listed
    #[arg(short, long, value_name = "N", default_value_t = 10)]
    limit: usize,
    /// Print one JSON object for each file, each on its own line
    #[arg(long)]
    json: bool,
    /// Picture to write, .svg or .png: the drawing with the listed troubles marked and numbered
    #[arg(short, long, value_name = "PIC")]
    picture: Option<PathBuf>,
    /// GeoJSON file to write, a feature for each listed trouble
    #[arg(long, value_name = "OUT")]
    geojson: Option<PathBuf>,
    /// File to write the repaired drawing to, .poly or another that holds segments
    #[arg(long, value_name = "OUT")]
    repair: Option<PathBuf>,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    writing: Writing,
}

/// A drawing that has been read.
struct Patient {
    name: String,
    /// What is not in the graph: markers, attributes.
    domain: DomainData,
    pslg: Pslg,
    rule: DomainRule,
    numbering: Numbering,
}

impl Doctor {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let outputs = self.outputs()?;
        let mut outcome = Ok(());
        for file in &self.files {
            match self.treat(file, &outputs, quiet) {
                Ok(true) => {}
                Ok(false) => outcome = outcome.and(Err(Failure::Troubles)),
                Err(failure @ Failure::BadInput(_)) => {
                    failure.report();
                    outcome = Err(Failure::NotAllRead);
                }
                Err(failure) => return Err(failure),
            }
        }
        outcome
    }

    /// Settles what is to be written.
    fn outputs(&self) -> Result<Outputs, Failure> {
        let asides = [&self.picture, &self.geojson].into_iter().flatten();
        let asides = asides.map(|path| (path.clone(), Content::Troubles));
        let repair = self
            .repair
            .iter()
            .map(|path| (path.clone(), Content::Domain));
        let outputs = self.writing.outputs(asides.chain(repair))?;
        let usage = |text: &str| Err(Failure::Usage(text.to_owned()));
        if !outputs.is_empty() && self.files.len() > 1 {
            return usage("--picture, --geojson and --repair need a single file to look at");
        }
        if outputs.use_stdout() && self.json {
            return usage("--json and --repair - both want standard output; name a file for one");
        }
        let is_picture = |p: &PathBuf| Format::from_path(p).is_none_or(Format::is_picture);
        if self.picture.as_ref().is_some_and(|p| !is_picture(p)) {
            return usage("--picture takes a .svg or .png; see --geojson");
        }
        Ok(outputs)
    }

    /// Examines a file, and repairs it if that is asked for; tells whether all is well in the end.
    fn treat(&self, file: &Path, outputs: &Outputs, quiet: bool) -> Result<bool, Failure> {
        let progress = Progress::new(quiet);
        let (patient, read) = timed(|| {
            let input = self.reading.open(file)?;
            outputs.spare(&input.files())?;
            Patient::read(&input, &progress)
        })?;
        let (found, examined) = timed(|| self.examine(&patient.pslg, &patient, &progress))?;
        let mut report = Report::new(&patient, &found, self.tolerance);
        let (mended, repaired) = timed(|| self.mend(&patient, &found, &progress))?;
        let writing = || self.write(outputs, &patient, &found, &mended, &progress);
        let (written, wrote) = timed(|| files::in_one_commit(writing))?;
        progress.finish();
        let is_well = mended
            .as_ref()
            .map_or(found.is_healthy(), Mended::is_healthy);
        if let Some((mended, out)) = mended.as_ref().zip(self.repair.as_ref()) {
            report = report.with_repair(mended.report(out, &patient, self.limit));
        }
        let report = report.took([read, examined, repaired, wrote]);
        if self.json {
            files::print_json(&report)?;
        } else if outputs.use_stdout() {
            // The repaired drawing is there.
            if !quiet {
                eprintln!("{report}");
            }
        } else {
            files::print(&report.to_string())?;
        }
        if !quiet && !self.json && !written.is_empty() {
            eprintln!("{}", crate::words::wrote(&written).unwrap_or_default());
        }
        Ok(is_well)
    }

    fn examine(
        &self,
        pslg: &Pslg,
        patient: &Patient,
        progress: &Progress,
    ) -> Result<Diagnosis, Failure> {
        let examiner = self.examiner(patient.rule, progress).limit(self.limit);
        let found = examiner.examine(pslg);
        found.map_err(|error| patient.failure(error))
    }

    fn examiner<'w>(&self, rule: DomainRule, progress: &'w Progress) -> Examiner<'w> {
        Examiner::new()
            .tolerance(self.tolerance)
            .domain(rule)
            .watch(progress)
    }

    /// Repairs, and examines the result.
    fn mend(
        &self,
        patient: &Patient,
        before: &Diagnosis,
        progress: &Progress,
    ) -> Result<Option<Mended>, Failure> {
        let Some(out) = &self.repair else {
            return Ok(None);
        };
        let keeps_polygons = self.writing.format(out) == Some(Format::GeoJson);
        let repair = self.examiner(patient.rule, progress).repair(&patient.pslg);
        let repair = repair.map_err(|error| patient.failure(error))?;
        let domain = mended::domain(&repair, patient, keeps_polygons, progress)?;
        let graph = domain.clone().take_pslg();
        let rule = domain.usual_rule;
        let after = self
            .examiner(rule, progress)
            .limit(self.limit)
            .examine(&graph);
        let after = after.map_err(|error| patient.failure(error))?;
        Ok(Some(Mended::new(repair, domain, before, after)))
    }

    fn write(
        &self,
        outputs: &Outputs,
        patient: &Patient,
        found: &Diagnosis,
        mended: &Option<Mended>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let marks = Describer::of(patient).marks(found);
        let view = TroublesView {
            points: &patient.pslg.points,
            segments: &patient.pslg.segments,
            marks: &marks,
        };
        let mut written = self.writing.troubles(outputs, &view, progress)?;
        if let Some(mended) = mended {
            written.extend(self.writing.domain(outputs, &mended.domain, progress)?);
        }
        Ok(written)
    }
}

impl Patient {
    fn read(input: &Input, progress: &Progress) -> Result<Self, Failure> {
        let (mut domain, unused) = input.domain(progress)?;
        progress.note(&unused);
        let name = input.name();
        Ok(Self {
            numbering: Numbering::of(&name, &domain),
            rule: domain.usual_rule,
            pslg: domain.take_pslg(),
            domain,
            name,
        })
    }

    fn base(&self) -> usize {
        self.numbering.base()
    }

    /// Says why the drawing cannot be examined; a bad tolerance is a usage error.
    fn failure(&self, error: delone::Error) -> Failure {
        self.numbering.failure(error)
    }
}

/// What a severity is called.
fn name_of(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}
