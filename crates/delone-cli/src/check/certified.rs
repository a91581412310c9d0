//! `--certificate`: does all that a certificate says hold for these files?
//!
//! Everything is found anew: files are hashed, the mesh is proven against the input with the bounds that the
//! certificate names, and what comes out is compared with the certificate entry by entry. The chains of segments
//! come from the table of lineage, as claims that the verifier proves. Program, version and options are taken from the
//! certificate: of them nothing in the files tells, and only its checksum vouches for them.

use super::report::Report;
use super::shortfall::Shortfall;
use crate::exit::Failure;
use crate::files::{self, Reading};
use crate::job::{Subject, proof_failure, rule_word};
use crate::progress::Progress;
use crate::sizing::Sizing;
use crate::timing::timed;
use delone::check::Verdict;
use delone_io::{Claim, Error, FileFact, Lineage, MeshCertificate, MeshData, Source, digest_file};
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// What stands for the hash of a file that is not there.
const MISSING: &str = "missing";

/// Reads a mesh, its domain and its certificate, and compares them.
pub fn check(
    file: &Path,
    domain: &Path,
    certificate: &Path,
    reading: &Reading,
    quiet: bool,
) -> Result<Report, Failure> {
    let progress = Progress::new(quiet);
    let (case, read) = timed(|| Case::read(file, domain, certificate, reading, &progress))?;
    let (report, check) = timed(|| case.judge(&progress))?;
    progress.finish();
    Ok(report.taken([read, check]))
}

/// All that is read.
struct Case {
    source: Source,
    mesh: MeshData,
    subject: Subject,
    claimed: MeshCertificate,
    /// The file of the certificate.
    name: String,
    lineage: Option<Lineage>,
    /// The files that the certificate names, as they are now.
    output: Vec<FileFact>,
    lineage_file: Option<FileFact>,
    /// Files of the mesh that the certificate does not name.
    unnamed: Vec<String>,
}

impl Case {
    fn read(
        file: &Path,
        domain: &Path,
        certificate: &Path,
        reading: &Reading,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let claimed = MeshCertificate::read(&Source::from_arg(certificate), progress);
        let claimed = claimed.map_err(files::unreadable)?;
        let input = reading.open(file)?;
        let mesh = input.mesh(progress)?;
        let subject = subject(&claimed, domain, reading, progress)?;
        let folders = [file, certificate].map(|path| path.parent().unwrap_or(Path::new("")));
        let now = |fact: &FileFact| look_up(fact, folders, progress);
        let output = claimed.output.iter().map(|fact| Ok(now(fact)?.1));
        let output = output.collect::<Result<Vec<_>, Failure>>()?;
        let table = claimed.lineage.as_ref().map(now).transpose()?;
        let lineage = match &table {
            Some((Some(path), _)) => {
                let segments = subject.pslg.segments.len();
                let lineage = Lineage::read(&Source::Path(path.clone()), segments, progress);
                Some(lineage.map_err(files::unreadable)?)
            }
            _ => None,
        };
        let members = input.files().into_iter();
        let names = members.filter_map(|path| Some(path.file_name()?.to_string_lossy().into()));
        let is_named = |name: &String| claimed.output.iter().any(|fact| fact.name == *name);
        Ok(Self {
            unnamed: names.filter(|name| !is_named(name)).collect(),
            name: certificate.display().to_string(),
            lineage_file: table.map(|(_, fact)| fact),
            source: Source::from_arg(file),
            mesh,
            subject,
            claimed,
            lineage,
            output,
        })
    }

    fn judge(self, progress: &Progress) -> Result<Report, Failure> {
        let Self {
            mesh,
            subject,
            claimed,
            lineage,
            ..
        } = &self;
        // What a format cannot hold of a mesh is claimed by the table, and proven like the rest.
        let edges: Cow<'_, [_]> = match (&mesh.constraints, lineage) {
            (Some(constraints), _) => (&constraints.edges[..]).into(),
            (None, Some(lineage)) => lineage.constrained_edges().into(),
            (None, None) => Cow::default(),
        };
        let edges = &edges[..];
        let points = &mesh.vertices.points;
        let chains = lineage.as_ref().map(|l| l.chains(&subject.pslg));
        let claim = Claim {
            chains: chains.as_deref(),
            is_refined: claimed.refined,
            asked: claimed.asked.as_ref(),
            ..subject.claim(points, &mesh.triangles, edges)
        };
        let prove = |claim: &Claim<'_>| {
            let proof = delone_io::prove(claim, progress);
            proof.map_err(|error| proof_failure(error, &subject.numbering))
        };
        let mut disagreements = self.unnamed.clone();
        for name in &mut disagreements {
            name.insert_str(0, "output: the certificate does not name ");
        }
        let mut proof = prove(&claim)?;
        if proof.is_err() && claim.chains.is_some() {
            // Perhaps it is not the mesh that is wrong, but what the table claims about it.
            let alone = prove(&Claim {
                chains: None,
                ..claim
            })?;
            if alone.is_ok() {
                let words = "lineage: the ways of its segments are not proven";
                disagreements.push(words.to_owned());
                proof = alone;
            }
        }
        let no_time = [std::time::Duration::ZERO; 2];
        let report = match proof {
            Ok(proof) => {
                let found = MeshCertificate::new(
                    claimed.made_by.clone(),
                    subject.facts.clone(),
                    subject.rule,
                    claimed.refined,
                    claimed.asked.clone(),
                    &mesh.triangles,
                    &proof,
                );
                let found = found.sealed(self.output.clone(), self.lineage_file.clone());
                disagreements.extend(claimed.disagreements(&found));
                if let Some(lineage) = lineage {
                    let regions = proof.regions.as_deref();
                    let words =
                        lineage.disagreements(&subject.pslg, points, edges, regions, progress);
                    disagreements.extend(words.map_err(files::unwritable)?);
                }
                let verdict = Verdict::Right(*proof.certificate());
                let absences = super::presence::Absences::default();
                let report = Report::new(&self.source, mesh, verdict, absences, no_time);
                let quality = proof.quality.as_ref();
                report.asked(quality.map(|quality| Shortfall::new(quality, mesh)))
            }
            Err(words) => {
                disagreements.push("mesh: nothing of it is proven".to_owned());
                let files = claimed.output.iter().zip(&self.output);
                let changed = files.filter(|(claimed, now)| claimed != now);
                disagreements
                    .extend(changed.map(|(fact, _)| {
                        format!("output: {} is not as it was written", fact.name)
                    }));
                Report::unproven(&self.source, mesh, words, no_time)
            }
        };
        let numbering = &subject.numbering;
        let (file, rule) = (numbering.file().to_owned(), rule_word(subject.rule));
        let is_one_based = numbering.base() == 1;
        let report = match subject.rule {
            Some(_) => report.against_file(file, rule, is_one_based, claimed.refined),
            None => report,
        };
        Ok(report.certified(self.name.clone(), disagreements))
    }
}

/// Reads the input as the command of the certificate did.
fn subject(
    claimed: &MeshCertificate,
    domain: &Path,
    reading: &Reading,
    progress: &Progress,
) -> Result<Subject, Failure> {
    let bad = |words: String| Failure::BadInput(format!("the certificate: {words}"));
    let asked = claimed.asked.as_ref();
    let folder = domain.parent().unwrap_or(Path::new(""));
    let names = asked.map_or(&[][..], |asked| &asked.sizing);
    let sizing = Sizing::named(names, folder).map_err(bad)?;
    let takes_areas = asked.is_some_and(|asked| asked.area_per_region);
    let command = (claimed.made_by.command.as_str(), takes_areas);
    let rule = claimed.rule().map_err(|error| bad(error.to_string()))?;
    // Older certificates do not say how the input was read.
    let reading = match &claimed.input.reading[..] {
        [] => reading.of_another_file(),
        given => Reading::named(given).map_err(bad)?,
    };
    let mut subject = Subject::read(domain, &reading, command, &sizing, |_| rule, progress)?;
    // The sample has no file; whoever has written one down has the same drawing.
    let sample = claimed.input.sample.as_deref();
    if let Some(name) = sample.filter(|name| Subject::is_sample(name, &subject.facts.hash)) {
        subject.facts.sample = Some(name.to_owned());
        subject.facts.files.clear();
    }
    Ok(subject)
}

/// Looks for a file beside the mesh or the certificate, and hashes it.
fn look_up(
    fact: &FileFact,
    folders: [&Path; 2],
    progress: &Progress,
) -> Result<(Option<PathBuf>, FileFact), Failure> {
    let is_name = Path::new(&fact.name).file_name() == Some(fact.name.as_ref());
    let places = folders.map(|folder| folder.join(&fact.name));
    let Some(path) = places.into_iter().find(|path| is_name && path.is_file()) else {
        let missing = FileFact {
            sha256: MISSING.to_owned(),
            ..fact.clone()
        };
        return Ok((None, missing));
    };
    match digest_file(&path, progress) {
        Ok(now) => Ok((Some(path), now)),
        Err(Error::Cancelled) => Err(Failure::Cancelled),
        Err(error) => Err(files::unreadable(error)),
    }
}
