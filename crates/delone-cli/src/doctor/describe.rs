//! Each trouble in a sentence, in the numbers of its file.

use super::Patient;
use crate::words::{list, measure};
use delone::doctor::{Diagnosis, Kind, Trouble};
use delone::{Point, Seed, VertexId};
use delone_io::Mark;

/// Knows how the file counts.
pub struct Describer {
    base: usize,
}

impl Describer {
    pub fn of(patient: &Patient) -> Self {
        let base = patient.base();
        Self { base }
    }

    /// Numbers and describes all that is listed.
    pub fn marks(&self, found: &Diagnosis) -> Vec<Mark> {
        let kinds = found.troubles.iter();
        let all = kinds.flat_map(|(kind, listed)| listed.first.iter().map(|t| (*kind, t)));
        let numbered = (1..).zip(all);
        numbered
            .map(|(number, (kind, trouble))| Mark {
                number,
                kind: kind.name(),
                severity: Some(kind.severity()),
                text: self.sentence(kind, trouble),
                points: trouble.points.iter().map(|v| self.point(v)).collect(),
                segments: trouble.segments.iter().map(|s| s + self.base).collect(),
                polygon: trouble.polygon.map(|p| p + self.base),
                size: trouble.size.filter(|size| size.is_finite()),
                at: trouble.at,
                to: trouble.to,
            })
            .collect()
    }

    /// Names the seeds of a trouble.
    pub fn seeds(&self, trouble: &Trouble) -> Vec<String> {
        let name = |seed: &Seed| match *seed {
            Seed::Hole(i) => format!("hole {}", i + self.base),
            Seed::Region(i) => format!("region {}", i + self.base),
        };
        trouble.seeds.iter().map(name).collect()
    }

    fn point(&self, v: &VertexId) -> usize {
        v.index() + self.base
    }

    fn sentence(&self, kind: Kind, trouble: &Trouble) -> String {
        let numbers = |numbers: Vec<usize>| {
            let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
            list(&words)
        };
        let points = || numbers(trouble.points.iter().map(|v| self.point(v)).collect());
        let segments = || numbers(trouble.segments.iter().map(|s| s + self.base).collect());
        let polygon = || trouble.polygon.map_or(0, |p| p + self.base);
        let at = trouble.at.map_or_else(String::new, place);
        let to = trouble.to.map_or_else(String::new, place);
        let size = trouble.size.unwrap_or(f64::NAN);
        let seeds = list(&self.seeds(trouble));
        match kind {
            Kind::Crossing => format!("segments {} cross at {at}", segments()),
            Kind::SeedOnSegment => {
                format!("the seed of {seeds} at {at} lies on segment {}", segments())
            }
            Kind::OpenPolygon => format!(
                "polygon {} is open at point {} at {at}",
                polygon(),
                points()
            ),
            Kind::Overlap => format!("segments {} overlap from {at} to {to}", segments()),
            Kind::VertexOnSegment => {
                format!("point {} on segment {} at {at}", points(), segments())
            }
            Kind::ZeroLength => format!("segment {} at {at}", segments()),
            Kind::NearVertices => format!("points {} are {size} apart at {at}", points()),
            Kind::NearSegment => {
                format!(
                    "point {} at {at} is {} from segment {}",
                    points(),
                    measure(size),
                    segments()
                )
            }
            Kind::UnclosedRing => format!(
                "the line from point {} at {at} to {to} misses itself by {size}",
                points().replace(" and ", " to point ")
            ),
            Kind::SelfTouch => format!(
                "the ring of segment {} in polygon {} meets point {} at {at} twice",
                segments(),
                polygon(),
                points()
            ),
            Kind::Misnested => {
                format!(
                    "the ring of segment {} in polygon {} at {at}",
                    segments(),
                    polygon()
                )
            }
            Kind::Nothing => "no triangle would be left".to_owned(),
            Kind::SeedOutside => format!("the seed of {seeds} at {at}"),
            Kind::SeedTwice => format!("the seeds of {seeds} lie in the same at {at}"),
            Kind::Needle | Kind::SharpCorner => {
                format!(
                    "{}° at point {} at {at}, between segments {}",
                    measure(size),
                    points(),
                    segments()
                )
            }
            Kind::FarAway => format!(
                "from {at} to {to}: but {} units in the last place",
                measure(size)
            ),
            Kind::Duplicate => format!("point {} at {at}", points().replace(" and ", " equals ")),
            Kind::Repeated => {
                format!(
                    "segment {} from {at} to {to}",
                    segments().replace(" and ", " equals ")
                )
            }
            Kind::OpenEnd | Kind::LoosePoint => format!("point {} at {at}", points()),
            Kind::Elongated => {
                format!("from {at} to {to}: {} times as long as wide", measure(size))
            }
            _ => at,
        }
    }
}

/// A place, written so that it reads back as the same.
fn place(p: Point) -> String {
    format!("({:?}, {:?})", p.x, p.y)
}
