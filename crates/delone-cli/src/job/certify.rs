//! `--certificate` and `--lineage`: papers that go with a mesh, and what they are about.
//!
//! Papers speak of files, not of this process: the input is read once more, and the mesh proven against that, in
//! just the way in which `delone check --certificate` does it.

use super::{Job, SAMPLE};
use crate::batch::Naming;
use crate::domain::Rule;
use crate::exit::Failure;
use crate::files::{self, Outputs, PaperNames, Reading};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::refinable::Refinable;
use crate::sample::scene_data;
use crate::sizing::Sizing;
use delone::{
    ConstrainedTriangulation, DomainRule, Point, Pslg, SizingField, Triangulation, VertexId,
};
use delone_io::{
    AskedFor, Claim, Format, InputFacts, Lineage, Maker, MeshCertificate, MeshView, Papers,
    ProveError, digest_file,
};
use std::path::{Path, PathBuf};

/// Options about papers.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Files")]
pub struct Certify {
    /// Write what was proven about the mesh, for `delone check --certificate`, and its lineage [default:
    /// the name of the mesh with .certificate.json and .lineage.csv]
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    certificate: Option<Option<PathBuf>>,
    /// Write a table that says of each vertex, constrained edge and triangle where it comes from (.csv, .parquet)
    #[arg(long, value_name = "FILE")]
    lineage: Option<PathBuf>,
}

impl Certify {
    /// Returns the same for one of several inputs.
    pub(super) fn for_one(&self, input: &Path, naming: &Naming<'_>) -> Result<Self, Failure> {
        let named = |file: &Path, option| naming.name(file, input, option);
        let certificate = match &self.certificate {
            Some(Some(file)) => Some(Some(named(file, "--certificate")?)),
            asked => asked.clone(),
        };
        let lineage = self.lineage.as_deref();
        let lineage = lineage.map(|file| named(file, "--lineage")).transpose()?;
        Ok(Self {
            certificate,
            lineage,
        })
    }

    /// Settles the names of the papers.
    pub(super) fn settle(&self, outputs: &mut Outputs) -> Result<(), Failure> {
        let usage = |text: &str| Err(Failure::Usage(text.to_owned()));
        if self.certificate.is_none() && self.lineage.is_none() {
            return Ok(());
        }
        if outputs.use_stdout() {
            return usage(
                "--certificate and --lineage go with files; name one for what goes to standard output",
            );
        }
        let Some(mesh) = outputs.mesh_file() else {
            return usage(
                "--certificate and --lineage go with a mesh that can be read back; name one with -o, as in \
                 `-o mesh.ele` or `-o mesh.vtu`",
            );
        };
        let named = |extension: &str| mesh.with_extension(extension);
        let table = self.lineage.as_deref();
        let is_table = |path| {
            let format = Format::from_path(path).filter(|format| format.is_built());
            matches!(format, Some(Format::Table | Format::Parquet))
        };
        if table.is_some_and(|path| !is_table(path)) {
            return usage(
                "--lineage writes a table; name one, as in `--lineage mesh.lineage.csv` or .parquet",
            );
        }
        let asked = self.certificate.as_ref();
        let certificate =
            asked.map(|file| file.clone().unwrap_or_else(|| named("certificate.json")));
        let lineage = self.lineage.clone();
        let papers = PaperNames {
            lineage: lineage.or_else(|| asked.map(|_| named("lineage.csv"))),
            certificate,
        };
        outputs.add_papers(papers)
    }
}

/// What the triangles are of.
pub enum OfMesh<'a> {
    /// Of bare points.
    Points(&'a Triangulation),
    /// Of a domain.
    Domain(&'a ConstrainedTriangulation),
}

/// What a command has made.
pub struct Made<'a> {
    /// The name of the command.
    pub command: &'static str,
    /// What was made.
    pub of: OfMesh<'a>,
    /// As it is written.
    pub mesh: &'a MeshView<'a>,
    /// What was asked of the triangles, if anything was.
    pub asked: Option<AskedFor>,
    /// Sizes that depend on the place.
    pub sizing: Option<&'a Sizing>,
    /// Options of the command that the mesh does not show.
    pub options: Vec<String>,
}

impl<'a> Made<'a> {
    /// Takes what a command has made; nothing was asked of the triangles.
    pub fn of(command: &'static str, of: OfMesh<'a>, mesh: &'a MeshView<'a>) -> Self {
        Self {
            command,
            of,
            mesh,
            asked: None,
            sizing: None,
            options: Vec::new(),
        }
    }
}

/// Papers that are ready.
#[derive(Default)]
pub struct Ready {
    names: PaperNames,
    certificate: Option<MeshCertificate>,
    lineage: Option<Lineage>,
}

impl Ready {
    /// Returns the papers with their names.
    pub fn view(&self) -> Papers<'_> {
        let names = &self.names;
        Papers {
            certificate: names.certificate.as_deref().zip(self.certificate.as_ref()),
            lineage: names.lineage.as_deref().zip(self.lineage.as_ref()),
        }
    }
}

/// An input, as its files have it.
pub struct Subject {
    /// What is drawn.
    pub pslg: Pslg,
    /// Which triangles belong to it; `None` for bare points.
    pub rule: Option<DomainRule>,
    /// How large triangles may be, if that depends on the place.
    pub sizes: Option<Box<dyn SizingField>>,
    /// What a certificate says about it.
    pub facts: InputFacts,
    /// How its file counts.
    pub numbering: Numbering,
}

impl Subject {
    /// Takes the built-in sample.
    fn sample(rule: impl Fn(&delone_io::DomainData) -> Option<DomainRule>) -> Self {
        let mut domain = scene_data(SAMPLE);
        let numbering = Numbering::of(SAMPLE.name(), &domain);
        let rule = rule(&domain);
        let pslg = domain.take_pslg();
        let facts = InputFacts {
            sample: Some(SAMPLE.name().to_owned()),
            ..InputFacts::of(&pslg, Vec::new())
        };
        Self {
            pslg,
            rule,
            sizes: None,
            facts,
            numbering,
        }
    }

    /// Tells whether a drawing is the built-in sample.
    pub fn is_sample(name: &str, hash: &str) -> bool {
        let is_it = || Self::sample(|_| None).facts.hash == hash;
        name == SAMPLE.name() && is_it()
    }

    /// Reads a file as the command of this name does; `rule` tells which triangles belong to it.
    pub fn read(
        path: &Path,
        reading: &Reading,
        (command, takes_areas): (&str, bool),
        sizing: &Sizing,
        rule: impl Fn(&delone_io::DomainData) -> Option<DomainRule>,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let input = reading.open(path)?;
        let Refinable {
            mut domain, sizes, ..
        } = match command {
            "mesh" => input.refinable(takes_areas, progress)?.0,
            _ => input.domain(progress)?.0.into(),
        };
        let numbering = Numbering::of(&input.name(), &domain);
        let sizes = sizing.build(&domain, sizes, progress)?;
        let rule = rule(&domain);
        let pslg = domain.take_pslg();
        let areas = Some(path.with_extension("area")).filter(|p| takes_areas && p.is_file());
        let files = input.files().into_iter().chain(sizing.files()).chain(areas);
        let facts = files.map(|file| digest_file(&file, progress).map_err(files::unreadable));
        Ok(Self {
            facts: InputFacts {
                reading: reading.given(),
                ..InputFacts::of(&pslg, facts.collect::<Result<_, _>>()?)
            },
            pslg,
            rule,
            sizes,
            numbering,
        })
    }

    /// Claims that this is the mesh of it.
    pub fn claim<'a>(
        &'a self,
        points: &'a [Point],
        triangles: &'a [[VertexId; 3]],
        edges: &'a [[VertexId; 2]],
    ) -> Claim<'a> {
        Claim {
            input: &self.pslg,
            rule: self.rule,
            points,
            triangles,
            edges,
            chains: None,
            is_refined: false,
            asked: None,
            sizes: self.sizes.as_deref(),
        }
    }
}

impl Job {
    /// Proves what was made and makes the papers that were asked for.
    pub fn certify(
        &self,
        outputs: &Outputs,
        made: &Made<'_>,
        progress: &Progress,
    ) -> Result<Ready, Failure> {
        let names = outputs.papers().clone();
        let lineage = match names.lineage {
            None => None,
            Some(_) => Some(match made.of {
                OfMesh::Points(triangulation) => Lineage::of_points(triangulation),
                OfMesh::Domain(result) => {
                    Lineage::of_domain(result, progress).map_err(files::unwritable)?
                }
            }),
        };
        let certificate = match names.certificate {
            None => None,
            Some(_) => Some(self.prove(made, lineage.as_ref(), progress)?),
        };
        Ok(Ready {
            names,
            certificate,
            lineage,
        })
    }

    fn prove(
        &self,
        made: &Made<'_>,
        lineage: Option<&Lineage>,
        progress: &Progress,
    ) -> Result<MeshCertificate, Failure> {
        let subject = self.subject(made, progress)?;
        let mesh = made.mesh;
        let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
        let chains = lineage.map(|lineage| lineage.chains(&subject.pslg));
        let claim = Claim {
            chains: chains.as_deref(),
            is_refined: made.asked.is_some(),
            asked: made.asked.as_ref(),
            ..subject.claim(mesh.points, mesh.triangles, edges)
        };
        let proof = match delone_io::prove(&claim, progress) {
            Ok(Ok(proof)) => proof,
            Ok(Err(words)) => {
                let words = words.join("; ");
                return Err(Failure::NotReached(format!(
                    "the mesh could not be proven, so nothing was written; without --certificate it would be: {words}"
                )));
            }
            Err(error) => return Err(proof_failure(error, &subject.numbering)),
        };
        let mut options = self.building.options();
        options.extend(made.options.iter().cloned());
        let maker = Maker {
            program: "delone".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            command: made.command.to_owned(),
            options,
        };
        Ok(MeshCertificate::new(
            maker,
            subject.facts,
            subject.rule,
            made.asked.is_some(),
            made.asked.clone(),
            mesh.triangles,
            &proof,
        ))
    }

    /// Reads the input once more.
    fn subject(&self, made: &Made<'_>, progress: &Progress) -> Result<Subject, Failure> {
        let rule = |domain: &delone_io::DomainData| match made.of {
            OfMesh::Points(_) => None,
            OfMesh::Domain(_) => Some(self.building.rule(domain)),
        };
        let none = Sizing::default();
        let sizing = made.sizing.unwrap_or(&none);
        match self.inputs.first() {
            None => Ok(Subject {
                sizes: sizing.build(&scene_data(SAMPLE), None, progress)?,
                ..Subject::sample(rule)
            }),
            Some(path) if path == Path::new("-") || !path.is_file() => {
                Err(Failure::Usage(format!(
                    "{}: --certificate names the input by the hash of its file; name a file that can be read twice",
                    path.display()
                )))
            }
            Some(path) => {
                let takes_areas = made.asked.as_ref().is_some_and(|a| a.area_per_region);
                let command = (made.command, takes_areas);
                Subject::read(path, &self.reading, command, sizing, rule, progress)
            }
        }
    }
}

/// Says why nothing could be proven.
pub fn proof_failure(error: ProveError, numbering: &Numbering) -> Failure {
    match error {
        ProveError::Input(error @ delone::Error::BadQuality { .. }) => {
            Failure::Usage(error.to_string())
        }
        ProveError::Input(error) => numbering.failure(error),
        ProveError::Asked(error) => files::unreadable(error),
        other => Failure::NotReached(other.to_string()),
    }
}

/// Returns the word of the command line for a rule.
pub fn rule_word(rule: Option<DomainRule>) -> String {
    rule.map_or_else(|| "points".to_owned(), |rule| Rule::from(rule).to_string())
}
