//! `delone check`: is this the Delaunay triangulation of its points, or of a domain? From the files
//! alone.

mod bounds;
mod certified;
mod drawing;
mod presence;
mod report;
mod shortfall;

use crate::batch::{self, Results, Run, Unit};
use crate::domain::Rule;
use crate::exit::Failure;
use crate::files::{self, Reading};
use crate::progress::Progress;
use crate::timing::timed;
use bounds::Bounds;
use delone::check::verify;
use delone_io::{Format, MeshData, Source};
use drawing::{Drawing, Findings};
use presence::Absences;
use report::Report;
use shortfall::Shortfall;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone check mesh.ele                      reads mesh.node and mesh.ele
  delone check mesh.ele --points survey.csv  and is every point of survey.csv in it?
  delone check mesh.ele --domain map.poly    is it the triangulation of that domain?
  delone check fine.ele --domain map.poly --min-angle 25 --max-edge 0.1
                                             a mesh that was refined: is it as good as asked?
  delone check fine.ele --domain map.poly --sizing 'distance:segments,at=0.01,growth=0.2'
  delone check fine.ele --domain map.poly --certificate fine.certificate.json
                                             does the certificate hold, byte by byte and proof by proof?
  delone check a.ele b.vtu --json            one JSON object a line
  delone check mesh.ele && echo trustworthy  the exit code tells: 0 right, 1 wrong";

const JSON: &str = "\
The JSON object of --json:
  file, right      the file, and whether it is the Delaunay triangulation
  points, vertices, duplicates, triangles, edges, hull_edges, hash
                   counts and name; all but points and triangles are null if it is wrong
  proven           what has been proven, clause by clause; empty if it is wrong
  domain           null without --domain; else its file and rule, and if the mesh is right the
                   numbers of added vertices (where segments cross), steiner (all that refinement has
                   added), steiner_on_segments, points carved away, subsegments, components, holes
  bounds           null if the mesh is wrong or no bound was named; else met, unmet (triangles that
                   break a bound), unexcused, unmet_by_reason (small_input_angle, locked_boundary,
                   precision), encroached, encroached_unexcused (subsegments, for --conforming),
                   steiner_on_locked (vertices that --keep-boundary forbids), worst (the first few
                   of each in words)
  certificate      null without --certificate; else its file, holds, and disagreements in words
  defects          their total, and the first few of each kind in words
  quality          angles in degrees, lengths in units of the coordinates (rounded numbers)
  seconds          wall time of the phases read and check
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Check that a mesh is a Delaunay triangulation, exactly
///
/// Verifies from the files alone and without trust in whoever made them: every triangle is
/// counter-clockwise, they cover the convex hull without gap or overlap, no point is missing, and
/// no circle contains a point; among four points on one circle the diagonal is the canonical one.
/// Signs are exact for all finite coordinates. The time is linear,
/// but for the sorting that --domain needs.
///
/// With --domain: every segment is there as a chain of edges, vertices were added only where segments
/// cross, and the triangles cover exactly what the rule leaves of the domain.
///
/// With --refined: vertices may also have been added inside the domain, and on segments as near as rounding
/// allows. With bounds: every triangle obeys them, or has an excuse: it lies at an angle of the
/// input below 60 degrees (which excuses angles only), or at a segment that had to stay as it was, or
/// its shortest edge is below 2^12 units in the last place of its coordinates. A triangle without an excuse
/// fails the check.
///
/// Of several files all are checked, several at once, even if some cannot be read; the exit code is then 3, and 1 if
/// all can be read but some are wrong.
#[derive(clap::Args, Clone)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Check {
    /// Meshes: .ele (with the .node beside it), .npy (with .points.npy), .vtu, .msh …, or `-`
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Also require that the vertices are the points of this file, in any order
    #[arg(long, value_name = "FILE")]
    points: Option<PathBuf>,
    /// Check against the domain of this file: .poly, GeoJSON, WKT …
    #[arg(long, value_name = "FILE", conflicts_with = "points")]
    domain: Option<PathBuf>,
    /// Which triangles should be there [default: as for `triangulate`]
    #[arg(long, value_enum, value_name = "RULE", requires = "domain")]
    rule: Option<Rule>,
    /// Also require that all a certificate says holds for this mesh, this domain and the files that it names,
    /// which lie beside the mesh or the certificate; bounds, rule and how the domain is read are those of the
    /// certificate
    #[arg(
        long,
        value_name = "FILE",
        requires = "domain",
        conflicts_with = "rule"
    )]
    certificate: Option<PathBuf>,
    /// Print one JSON object for each mesh that can be read, each on its own line
    #[arg(long)]
    json: bool,
    /// How many meshes are checked at once; by default as many as the machine runs at once
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    #[command(flatten)]
    bounds: Bounds,
    #[command(flatten)]
    reading: Reading,
}

impl Check {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let files = families(&batch::expand(&self.files)?);
        self.require_one_reader_of_stdin(&files)?;
        self.require_sense(&files)?;
        if let [file] = &files[..] {
            return self.judge(file, [quiet; 2]);
        }
        let unit = |file: PathBuf| {
            let command = self.clone();
            // Of several files at once none has a bar of its own.
            Unit::reading(&file.clone(), move || command.judge(&file, [true, quiet]))
        };
        let run = Run {
            jobs: self.jobs,
            results: Results::AsTheyAre,
            quiet,
        };
        run.all(files.into_iter().map(unit).collect())
    }

    /// Checks a file and says what has been found; quiet are the work, and whoever prints that nothing is wrong.
    fn judge(&self, file: &Path, [works_quietly, quiet]: [bool; 2]) -> Result<(), Failure> {
        let report = self.check(file, works_quietly)?;
        if self.json {
            files::print(&report.json())?;
        } else if !quiet || !report.is_passed() {
            files::print(&report.to_string())?;
        }
        match report.is_passed() {
            true => Ok(()),
            false => Err(Failure::CheckFailed),
        }
    }

    /// Requires that nothing is said twice.
    fn require_sense(&self, files: &[PathBuf]) -> Result<(), Failure> {
        let usage = |text: &str| Err(Failure::Usage(text.to_owned()));
        match self.certificate {
            _ if self.jobs.is_some() && files.len() < 2 => {
                usage("--jobs is about several files, and there is but one")
            }
            None => Ok(()),
            Some(_) if self.bounds.is_refined() => {
                usage("--certificate says what was asked; leave out --refined and the bounds")
            }
            Some(_) if files.len() > 1 => usage("--certificate is about one mesh; name one"),
            Some(_) => Ok(()),
        }
    }

    fn require_one_reader_of_stdin(&self, files: &[PathBuf]) -> Result<(), Failure> {
        let is_stdin = |file: &PathBuf| file == Path::new("-");
        let others = [("--points", &self.points), ("--domain", &self.domain)];
        for (option, file) in others {
            if !file.as_ref().is_some_and(is_stdin) {
                continue;
            }
            if files.iter().any(is_stdin) {
                return Err(Failure::Usage(format!(
                    "mesh and {option} both want standard input; name a file for one"
                )));
            }
            if files.len() > 1 {
                return Err(Failure::Usage(format!(
                    "{option}: standard input can be read but once; name a file to check several meshes against"
                )));
            }
        }
        Ok(())
    }

    fn check(&self, file: &Path, quiet: bool) -> Result<Report, Failure> {
        if let (Some(certificate), Some(domain)) = (&self.certificate, &self.domain) {
            return certified::check(file, domain, certificate, &self.reading, quiet);
        }
        let source = Source::from_arg(file);
        let progress = Progress::new(quiet);
        let ((mesh, drawing), read) = timed(|| {
            let input = self.reading.open(file)?;
            let mesh = input.mesh(&progress)?;
            progress.note(&input.named(files::notes(&mesh.vertices)));
            Ok((mesh, self.drawing(&progress)?))
        })?;
        let ((findings, absences), check) = timed(|| {
            let findings = match &drawing {
                Some(drawing) => drawing.verify(&mesh, &self.bounds, &progress)?,
                None => verify(&mesh.vertices.points, &mesh.triangles, &progress)
                    .map(Findings::from)
                    .map_err(|error| failure(&source, error))?,
            };
            Ok((findings, self.absences(&mesh, &progress)?))
        })?;
        progress.finish();
        let Findings { verdict, quality } = findings;
        let report = Report::new(&source, &mesh, verdict, absences, [read, check]);
        Ok(match drawing {
            Some(drawing) => report
                .against(&drawing, self.bounds.is_refined())
                .asked(quality.map(|quality| Shortfall::new(&quality, &mesh))),
            None => report,
        })
    }

    /// Reads the domain, if one is named.
    fn drawing(&self, progress: &Progress) -> Result<Option<Drawing>, Failure> {
        let read = |file: &PathBuf| {
            let source = Source::from_arg(file);
            let domain = self.reading.of_another_file().domain(&source, progress)?;
            let sizes = self.bounds.sizing.build(&domain, None, progress)?;
            Ok(Drawing::new(&source, domain, self.rule, sizes))
        };
        self.domain.as_ref().map(read).transpose()
    }

    fn absences(&self, mesh: &MeshData, progress: &Progress) -> Result<Absences, Failure> {
        let Some(file) = &self.points else {
            return Ok(Absences::default());
        };
        let source = Source::from_arg(file);
        let expected = self.reading.of_another_file().points(&source, progress)?;
        Ok(presence::compare(
            &source,
            &expected.points,
            &mesh.vertices.points,
        ))
    }
}

/// Takes the files of one family together: `mesh.*` of the shell names one mesh, not four.
fn families(files: &[PathBuf]) -> Vec<PathBuf> {
    let mut seen = BTreeSet::new();
    let key = |file: &PathBuf| match Format::from_path(file) {
        Some(Format::Node | Format::Ele | Format::Edge | Format::Neigh) => {
            file.with_extension("ele")
        }
        _ => file.clone(),
    };
    files
        .iter()
        .map(key)
        .filter(|f| seen.insert(f.clone()))
        .collect()
}

fn failure(source: &Source, error: delone::Error) -> Failure {
    match error {
        delone::Error::Cancelled => Failure::Cancelled,
        _ => Failure::BadInput(format!("{source}: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_files_of_a_family_are_checked_once() {
        let files = ["m.edge", "m.ele", "m.node", "n.vtu"].map(PathBuf::from);
        assert_eq!(families(&files), ["m.ele", "n.vtu"].map(PathBuf::from));
    }
}
