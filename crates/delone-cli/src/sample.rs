//! `delone sample`: points and domains to try things on, embedded, drawn or generated.

use crate::exit::Failure;
use crate::files::{self, Content, Input, Outputs, Writing};
use crate::progress::Progress;
use crate::words::{self, counted};
use delone::{Point, Region};
use delone_io::{DomainData, Format, PointSet, ReadOptions, Source};
use delone_samples::{Distribution, Domain, Drawing, Scene, Sheet};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The name of the embedded points.
const EMBEDDED: &str = "populated-places";

const ABOUT_EMBEDDED: &str = "1249 places of the world: longitude, latitude, population";

/// The most points that a triangulation takes: 32 bits number its half-edges, six for a point.
const MAX_POINTS: usize = (u32::MAX / 6) as usize;

const CSV: &[u8] = include_bytes!("../samples/populated-places.csv");

const EXAMPLES: &str = "\
Examples:
  delone sample                                    list them
  delone sample lake -o lake.poly                  points, segments, holes and regions
  delone sample coast -n 10000 | delone triangulate - --from poly --picture coast.png
  delone sample populated-places -o cities.csv     longitude, latitude, population
  delone sample uniform -n 1000000 --seed 7 -o points.npy
  delone sample tilted-grid -n 3600 | delone triangulate - --json";

const JSON: &str = "\
The JSON object of --json:
  files            the files written
  seed             the seed of what is generated
  points, segments, holes, regions
                   counts
Without NAME one object for each sample, each on its own line:
  name, about      what it is called, and what it is
  kind             points or domain
  any_number       whether --count says how many points or segments";

/// List and write samples: points and domains, embedded, drawn, or generated for benchmarks
///
/// The same name, count and seed give the same coordinates, bit for bit, on every machine.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Sample {
    /// Name of the sample; without it the samples are listed
    #[arg(value_parser = name)]
    name: Option<Name>,
    /// File to write: points to .csv, .xyz, .npy, .node, .vtu, .svg or .png, domains to .poly or
    /// .geojson; by default CSV or .poly on standard output
    #[arg(short, long, value_name = "OUT", requires = "name")]
    output: Vec<PathBuf>,
    /// Number of points or segments to generate
    #[arg(short = 'n', long, default_value_t = 1000, value_parser = clap::value_parser!(u32))]
    count: u32,
    /// Seed of the random numbers
    #[arg(short, long, default_value_t = 1)]
    seed: u64,
    /// Print one JSON object: of what is written, or without NAME of each sample
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    writing: Writing,
}

/// What has been written; the fields are the keys of `--json`.
#[derive(Default, Serialize)]
struct Figures {
    files: Vec<String>,
    seed: u64,
    points: usize,
    segments: usize,
    holes: usize,
    regions: usize,
    #[serde(skip)]
    in_words: String,
}

/// A sample as `--json` lists it.
#[derive(Serialize)]
struct Listed {
    name: &'static str,
    kind: &'static str,
    about: &'static str,
    any_number: bool,
}

fn all() -> Vec<Listed> {
    let listed = |kind, any_number| {
        move |(name, about)| Listed {
            name,
            kind,
            about,
            any_number,
        }
    };
    let embedded = [(EMBEDDED, ABOUT_EMBEDDED)].map(listed("points", false));
    let points = Distribution::ALL.map(|d| (d.name(), d.about()));
    let points = points.map(listed("points", true));
    let scenes = Scene::ALL.map(|s| (s.name(), s.about()));
    let scenes = scenes.map(listed("domain", false));
    let domains = Domain::ALL.map(|d| (d.name(), d.about()));
    let domains = domains.map(listed("domain", true));
    let more = points.into_iter().chain(scenes).chain(domains);
    embedded.into_iter().chain(more).collect()
}

/// A sample that can be had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Name {
    /// The embedded points.
    Embedded,
    /// Points of any number.
    Points(Distribution),
    /// A domain of one size.
    Scene(Scene),
    /// A domain of any size.
    Domain(Domain),
}

fn name(text: &str) -> Result<Name, String> {
    if text == EMBEDDED {
        return Ok(Name::Embedded);
    }
    let points = || text.parse().map(Name::Points).ok();
    let domain = || text.parse().map(Name::Domain).ok();
    let mut scenes = Scene::ALL.into_iter();
    let scene = scenes.find(|s| s.name() == text).map(Name::Scene);
    let found = scene.or_else(points).or_else(domain);
    found.ok_or_else(|| "no such sample; `delone sample` lists them".to_owned())
}

/// Returns the embedded points as an input.
fn embedded() -> Input {
    let source = Source::Memory {
        name: format!("{EMBEDDED}.csv"),
        bytes: CSV.to_vec(),
    };
    Input::new(source, Some(Format::Table), ReadOptions::default())
}

impl Sample {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let progress = Progress::new(quiet);
        let Some(name) = self.name else {
            return match self.json {
                true => all().iter().try_for_each(files::print_json),
                false => files::print(&listing()),
            };
        };
        if self.json && self.output.iter().all(|path| path == Path::new("-")) {
            let clash = "--json and the sample both want standard output; name a file with -o";
            return Err(Failure::Usage(clash.to_owned()));
        }
        let (written, what) = match name {
            Name::Embedded => {
                let (points, unused) = embedded().points(&progress)?;
                progress.note(&unused);
                self.write_points(&points, &progress)?
            }
            Name::Points(distribution) => {
                require_room(self.count as usize)?;
                let points = distribution.points(self.count as usize, self.seed);
                self.write_points(&point_set(points), &progress)?
            }
            Name::Scene(scene) => self.write_domain(scene_data(scene), &progress)?,
            Name::Domain(domain) => {
                // A loose segment has two points.
                require_room(2 * self.count as usize)?;
                let drawing = domain.draw(self.count as usize, self.seed);
                self.write_domain(domain_data(drawing), &progress)?
            }
        };
        progress.finish();
        if self.json {
            return files::print_json(&what);
        }
        if !quiet && !written.is_empty() {
            words::wrote_what(&what.in_words, &written);
        }
        Ok(())
    }

    fn write_points(
        &self,
        points: &PointSet,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, Figures), Failure> {
        let outputs = self.outputs(Content::Points, Format::Table)?;
        let written = self.writing.points(&outputs, points, progress)?;
        let points = points.points.len();
        let figures = Figures {
            points,
            in_words: counted(points, "point", "points"),
            ..self.figures(&written)
        };
        Ok((written, figures))
    }

    fn write_domain(
        &self,
        mut domain: DomainData,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, Figures), Failure> {
        let outputs = self.outputs(Content::Domain, Format::Poly)?;
        let written = self.writing.domain(&outputs, &domain, progress)?;
        let pslg = domain.take_pslg();
        let figures = Figures {
            points: pslg.points.len(),
            segments: pslg.segments.len(),
            holes: pslg.holes.len(),
            regions: pslg.regions.len(),
            in_words: words::domain(&pslg),
            ..self.figures(&written)
        };
        Ok((written, figures))
    }

    /// Begins the figures with what is known without the sample.
    fn figures(&self, written: &[PathBuf]) -> Figures {
        Figures {
            seed: self.seed,
            files: written.iter().map(|p| p.display().to_string()).collect(),
            ..Figures::default()
        }
    }

    fn outputs(&self, content: Content, default: Format) -> Result<Outputs, Failure> {
        let wanted = self.output.iter().map(|o| (o.clone(), content));
        let outputs = self.writing.outputs(wanted)?;
        if outputs.is_empty() {
            return self.writing.stdout(content, default);
        }
        Ok(outputs)
    }
}

fn point_set(points: Vec<[f64; 2]>) -> PointSet {
    PointSet {
        points: points.into_iter().map(Point::from).collect(),
        ..PointSet::default()
    }
}

fn domain_data(drawing: Drawing) -> DomainData {
    let Drawing {
        points,
        segments,
        holes,
    } = drawing;
    DomainData::from_rows(points, segments, holes).expect("bug: a sample names no point")
}

/// Draws a scene.
pub fn scene_data(scene: Scene) -> DomainData {
    let Sheet {
        points,
        segments,
        markers,
        holes,
        regions,
    } = scene.draw();
    let region = |(at, attribute): ([f64; 2], f64)| Region {
        at: at.into(),
        attribute,
        max_area: None,
    };
    DomainData {
        segment_markers: (!markers.is_empty()).then_some(markers),
        regions: regions.into_iter().map(region).collect(),
        ..domain_data(Drawing {
            points,
            segments,
            holes,
        })
    }
}

/// Requires that so many points can be triangulated, and fit into memory.
///
/// Ctrl-C ends the process while they are generated, for there is nothing to clean up yet.
fn require_room(count: usize) -> Result<(), Failure> {
    let given = words::count(count);
    if count > MAX_POINTS {
        let limit = words::count(MAX_POINTS);
        return Err(Failure::NotReached(format!(
            "{given} points: more than {limit} cannot be triangulated; ask for fewer"
        )));
    }
    // Given back at once: generating needs as much, and would abort for want of it.
    Vec::<Point>::new().try_reserve_exact(count).map_err(|_| {
        Failure::NotReached(format!(
            "{given} points do not fit into memory; ask for fewer"
        ))
    })
}

fn listing() -> String {
    let row = |name: &str, about: &str| format!("\n  {name:18} {about}");
    let mut text = "Points, embedded:".to_owned();
    text += &row(EMBEDDED, ABOUT_EMBEDDED);
    text += &row("", "(made with Natural Earth, public domain)");
    text += "\n\nPoints, of any number (--count) and seed (--seed):";
    text.extend(Distribution::ALL.map(|d| row(d.name(), d.about())));
    text += "\n\nDomains:";
    text.extend(Scene::ALL.map(|s| row(s.name(), s.about())));
    text += "\n\nDomains, of any number of segments (--count) and seed:";
    text.extend(Domain::ALL.map(|d| row(d.name(), d.about())));
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_has_a_name_of_its_own() {
        let points = Distribution::ALL.map(|d| (d.name(), Name::Points(d)));
        let scenes = Scene::ALL.map(|s| (s.name(), Name::Scene(s)));
        let domains = Domain::ALL.map(|d| (d.name(), Name::Domain(d)));
        for (text, sample) in points.into_iter().chain(scenes).chain(domains) {
            assert_eq!(name(text), Ok(sample));
        }
        assert_eq!(name(EMBEDDED), Ok(Name::Embedded));
        assert!(name("pond").is_err());
    }
}
