//! The outcome of a check, for people and for programs.

use super::drawing::Drawing;
use super::presence::Absences;
use super::shortfall::Shortfall;
use crate::memory::peak_rss_bytes;
use crate::words::{counted, duration, measure};
use delone::check::{self, Certificate, DomainNumbers, Statistics, Verdict};
use delone_io::{MeshData, Source};
use serde::Serialize;
use std::fmt;
use std::time::Duration;

/// The verdict with its figures; the fields are the keys of `--json`, in this order.
#[derive(Serialize)]
pub struct Report {
    file: String,
    right: bool,
    points: usize,
    vertices: Option<usize>,
    duplicates: Option<usize>,
    triangles: usize,
    edges: Option<usize>,
    hull_edges: Option<usize>,
    hash: Option<String>,
    proven: &'static [&'static str],
    domain: Option<Domain>,
    bounds: Option<Shortfall>,
    certificate: Option<Agreement>,
    defects: Listed,
    quality: Option<Shapes>,
    seconds: Seconds,
    peak_rss_bytes: Option<u64>,
    /// Whether a file counts from 1; words always count from 0.
    #[serde(skip)]
    one_based: bool,
    /// Whether the mesh has constrained edges.
    #[serde(skip)]
    is_of_domain: bool,
    /// Whether it may have Steiner points.
    #[serde(skip)]
    is_refined: bool,
    #[serde(skip)]
    numbers: Option<DomainNumbers>,
}

/// The domain that the mesh was checked against; the numbers are null if it is wrong.
#[derive(Serialize)]
struct Domain {
    file: String,
    rule: String,
    added: Option<usize>,
    steiner: Option<usize>,
    steiner_on_segments: Option<usize>,
    carved: Option<usize>,
    subsegments: Option<usize>,
    components: Option<usize>,
    holes: Option<usize>,
}

/// Whether a certificate holds.
#[derive(Serialize)]
struct Agreement {
    file: String,
    holds: bool,
    disagreements: Vec<String>,
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.holds {
            return write!(f, "{} holds: every statement was found anew", self.file);
        }
        write!(f, "{} does NOT hold:", self.file)?;
        let words = self.disagreements.iter();
        words
            .take(MOST_SHOWN)
            .try_for_each(|words| write!(f, "\n  - {words}"))?;
        match self.disagreements.len().saturating_sub(MOST_SHOWN) {
            0 => Ok(()),
            more => write!(f, "\n  and {more} more"),
        }
    }
}

/// Most disagreements with a certificate that people are shown.
const MOST_SHOWN: usize = 16;

/// Defects: how many, and some of them in words.
#[derive(Default, Serialize)]
struct Listed {
    total: usize,
    listed: Vec<String>,
}

/// Angles in degrees, lengths in units of the coordinates.
#[derive(Serialize)]
struct Shapes {
    min_angle: f64,
    mean_min_angle: f64,
    max_angle: f64,
    shortest_edge: f64,
    longest_edge: f64,
}

/// Wall time of the phases, in seconds.
#[derive(Serialize)]
struct Seconds {
    read: f64,
    check: f64,
}

impl Report {
    /// Puts a report together; `absences` are defects beyond the verdict's.
    pub fn new(
        source: &Source,
        mesh: &MeshData,
        verdict: impl Into<Option<Verdict>>,
        absences: Absences,
        seconds: [Duration; 2],
    ) -> Self {
        let (certificate, mut defects) = match verdict.into() {
            Some(Verdict::Right(certificate)) => (Some(certificate), Listed::default()),
            Some(Verdict::Wrong(defects)) => (None, Listed::from(&defects)),
            None => (None, Listed::default()),
        };
        defects.total += absences.total;
        defects.listed.extend(absences.listed);
        let certificate = certificate.filter(|_| defects.total == 0);
        let numbers = certificate.and_then(|c| c.domain);
        let [read, check] = seconds.map(|s| s.as_secs_f64());
        Self {
            file: source.to_string(),
            right: certificate.is_some(),
            points: mesh.vertices.points.len(),
            vertices: certificate.map(|c| c.vertices),
            duplicates: certificate.map(|c| c.duplicates),
            triangles: mesh.triangles.len(),
            edges: certificate.map(|c| c.edges),
            hull_edges: certificate.map(|c| c.hull_edges),
            hash: certificate.map(|c| c.hash.to_string()),
            proven: certificate.map_or(&[], |c| proven(&c)),
            domain: None,
            bounds: None,
            certificate: None,
            defects,
            quality: certificate.and_then(|_| Shapes::of(mesh)),
            seconds: Seconds { read, check },
            peak_rss_bytes: peak_rss_bytes(),
            one_based: mesh.vertices.base == 1,
            is_of_domain: mesh.constraints.is_some(),
            is_refined: false,
            numbers,
        }
    }

    /// Says that nothing is proven, and why.
    pub fn unproven(
        source: &Source,
        mesh: &MeshData,
        words: Vec<String>,
        seconds: [Duration; 2],
    ) -> Self {
        let absences = Absences {
            total: words.len(),
            listed: words,
        };
        Self::new(source, mesh, None, absences, seconds)
    }

    /// Says that the mesh was checked against a domain, as it is or refined.
    pub fn against(self, drawing: &Drawing, is_refined: bool) -> Self {
        let (file, rule) = (drawing.file.clone(), drawing.rule.to_string());
        self.against_file(file, rule, drawing.is_one_based, is_refined)
    }

    /// Says that the mesh was checked against the domain of a file.
    pub fn against_file(
        mut self,
        file: String,
        rule: String,
        is_one_based: bool,
        is_refined: bool,
    ) -> Self {
        if self.right && is_refined {
            self.proven = &DomainNumbers::PROVEN_REFINED;
        }
        self.is_refined = is_refined;
        self.one_based |= is_one_based;
        let numbers = self.numbers.as_ref();
        self.domain = Some(Domain {
            file,
            rule,
            added: numbers.map(|n| n.added),
            steiner: numbers.map(|n| n.on_segments + n.free),
            steiner_on_segments: numbers.map(|n| n.on_segments),
            carved: numbers.map(|n| n.carved),
            subsegments: numbers.map(|n| n.subsegments),
            components: numbers.map(|n| n.components),
            holes: numbers.map(|n| n.holes),
        });
        self
    }

    /// Says how the mesh compares with what was asked of it, if anything was.
    pub fn asked(self, bounds: Option<Shortfall>) -> Self {
        Self { bounds, ..self }
    }

    /// Says how long reading and checking took.
    pub fn taken(self, seconds: [Duration; 2]) -> Self {
        let [read, check] = seconds.map(|s| s.as_secs_f64());
        Self {
            seconds: Seconds { read, check },
            ..self
        }
    }

    /// Says where a certificate disagrees with what was found.
    pub fn certified(self, file: String, disagreements: Vec<String>) -> Self {
        Self {
            certificate: Some(Agreement {
                file,
                holds: disagreements.is_empty(),
                disagreements,
            }),
            ..self
        }
    }

    /// Tells whether nothing is wrong, and nothing is missing without an excuse.
    pub fn is_passed(&self) -> bool {
        let holds = self.certificate.as_ref().is_none_or(|c| c.holds);
        self.right && holds && self.bounds.as_ref().is_none_or(Shortfall::is_met)
    }

    /// Writes the JSON object, on one line.
    pub fn json(&self) -> String {
        serde_json::to_string(self).expect("bug: numbers and strings always serialise")
    }

    fn write_certificate(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points = counted(self.points, "point", "points");
        match &self.domain {
            None => writeln!(
                f,
                "{}: right. This is the Delaunay triangulation of its {points}.",
                self.file
            )?,
            Some(domain) => writeln!(
                f,
                "{}: right. This is {} constrained Delaunay triangulation of {} ({}).",
                self.file,
                if self.is_refined { "a refined" } else { "the" },
                domain.file,
                domain.rule
            )?,
        }
        let part = |n: Option<usize>, one, many| counted(n.unwrap_or(0), one, many);
        writeln!(
            f,
            "  {}, {}, {}, {}, {}",
            part(self.vertices, "vertex", "vertices"),
            part(self.duplicates, "duplicate", "duplicates"),
            counted(self.triangles, "triangle", "triangles"),
            part(self.edges, "edge", "edges"),
            part(self.hull_edges, "edge on the border", "edges on the border"),
        )?;
        if let Some(domain) = &self.domain {
            writeln!(f, "  {domain}")?;
        }
        if let Some(shapes) = &self.quality {
            writeln!(f, "  {shapes}")?;
        }
        if let Some(bounds) = &self.bounds {
            writeln!(f, "  {bounds}")?;
            self.write_base(f, bounds.names_any())?;
        }
        writeln!(f, "  hash {}", self.hash.as_deref().unwrap_or("none"))?;
        writeln!(f, "  Proven from the files alone, in exact arithmetic:")?;
        for clause in self.proven {
            writeln!(f, "  - {clause}")?;
        }
        self.write_agreement(f)?;
        self.write_effort(f)
    }

    fn write_defects(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let defects = counted(self.defects.total, "defect", "defects");
        writeln!(f, "{}: wrong, {defects}:", self.file)?;
        for defect in &self.defects.listed {
            writeln!(f, "  - {defect}")?;
        }
        match self.defects.total - self.defects.listed.len() {
            0 => {}
            more => writeln!(
                f,
                "  and {} of the same kinds",
                counted(more, "other", "others")
            )?,
        }
        self.write_base(f, true)?;
        if self.is_of_domain && self.domain.is_none() {
            writeln!(
                f,
                "  (It has segments: --domain FILE checks it against what was drawn.)"
            )?;
        }
        self.write_agreement(f)?;
        self.write_effort(f)
    }

    fn write_agreement(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let agreement = self.certificate.as_ref();
        agreement.map_or(Ok(()), |agreement| writeln!(f, "  {agreement}"))
    }

    /// Warns of numbers that are not those of the file.
    fn write_base(&self, f: &mut fmt::Formatter<'_>, has_numbers: bool) -> fmt::Result {
        if self.one_based && has_numbers {
            writeln!(f, "  (Numbers here count from 0; a file counts from 1.)")?;
        }
        Ok(())
    }

    fn write_effort(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [read, check] =
            [self.seconds.read, self.seconds.check].map(|s| duration(Duration::from_secs_f64(s)));
        write!(f, "  read in {read}, checked in {check}")
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.right {
            self.write_certificate(f)
        } else {
            self.write_defects(f)
        }
    }
}

impl From<&delone::check::Defects> for Listed {
    fn from(defects: &delone::check::Defects) -> Self {
        Self {
            total: defects.total(),
            listed: defects.listed().iter().map(ToString::to_string).collect(),
        }
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |n: Option<usize>, one, many| counted(n.unwrap_or(0), one, many);
        write!(
            f,
            "{}, {}, {}, {}, {}, {}",
            part(self.subsegments, "subsegment", "subsegments"),
            part(self.added, "vertex added", "vertices added"),
            part(self.steiner, "Steiner point", "Steiner points"),
            part(self.components, "component", "components"),
            part(self.holes, "hole", "holes"),
            part(self.carved, "point carved away", "points carved away"),
        )
    }
}

/// Returns what a certificate proves.
fn proven(certificate: &Certificate) -> &'static [&'static str] {
    match certificate.domain {
        None => &Certificate::PROVEN,
        Some(_) => &DomainNumbers::PROVEN,
    }
}

impl Shapes {
    /// Measures a mesh; `None` without triangles.
    fn of(mesh: &MeshData) -> Option<Self> {
        let quality: Statistics = check::statistics(&mesh.vertices.points, &mesh.triangles);
        (quality.triangles > 0).then_some(Self {
            min_angle: quality.min_angle,
            mean_min_angle: quality.mean_min_angle,
            max_angle: quality.max_angle,
            shortest_edge: quality.shortest_edge,
            longest_edge: quality.longest_edge,
        })
    }
}

impl fmt::Display for Shapes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "smallest angle {}°, per triangle {}° on average; edges {} to {} long",
            measure(self.min_angle),
            measure(self.mean_min_angle),
            measure(self.shortest_edge),
            measure(self.longest_edge),
        )
    }
}
