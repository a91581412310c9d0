//! What the library says about segments, holes and regions, in the numbers of their file.

use crate::exit::Failure;
use delone::{ConstrainedTriangulation, Error, Seed, VertexId, Warning};
use delone_io::{DomainData, Lines, PointSet};

/// How the file of an input counts.
#[derive(Clone)]
pub struct Numbering {
    file: String,
    /// The number of the first point; segments, holes and regions are counted from it too.
    base: usize,
    lines: Lines,
    /// What is to be done about segments that cross.
    about_crossings: &'static str,
}

impl Numbering {
    /// Takes the numbering of a domain read from `file`.
    pub fn of(file: &str, domain: &DomainData) -> Self {
        Self::of_points(file, &domain.vertices)
    }

    /// Takes the numbering of points read from `file`.
    pub fn of_points(file: &str, points: &PointSet) -> Self {
        Self {
            file: file.to_owned(),
            base: points.base as usize,
            lines: points.lines.clone(),
            about_crossings: "--crossings split",
        }
    }

    /// Says of segments that cross that this is to be done about them.
    pub fn about_crossings(self, about_crossings: &'static str) -> Self {
        Self {
            about_crossings,
            ..self
        }
    }

    /// Says why the input cannot be triangulated.
    pub fn failure(&self, error: Error) -> Failure {
        let is_refused = matches!(
            error,
            Error::NotFinite { .. }
                | Error::BadSegment { .. }
                | Error::Crossing { .. }
                | Error::BadPolygon { .. }
                | Error::OpenPolygon { .. }
                | Error::BadArea { .. }
                | Error::SeedNotFinite { .. }
                | Error::SeedOnSegment { .. }
                | Error::BadSize { .. }
                | Error::BadWeight { .. }
                | Error::WeightNotPositive { .. }
                | Error::ValueNotFinite { .. }
                | Error::ValuesDiffer { .. }
                | Error::BadTriangle { .. }
                | Error::BadStart { .. }
                | Error::SameSide { .. }
                | Error::TooFewData { .. }
                | Error::CollinearData { .. }
                | Error::DatumOutside { .. }
                | Error::BadDomain { .. }
        );
        let is_usage = matches!(
            error,
            Error::BadLevel { .. }
                | Error::BadGrid { .. }
                | Error::BadChoice { .. }
                | Error::NotTaken { .. }
        );
        let hint = match error {
            Error::Cancelled => return Failure::Cancelled,
            Error::Crossing { .. } => format!(": {}", self.about_crossings),
            Error::ValuesDiffer { vertices, .. } => match self.line(vertices[0].index()) {
                Some(line) => format!(": --average; the first stands on line {line}"),
                None => ": --average".to_owned(),
            },
            _ => String::new(),
        };
        let place = culprit(&error).map_or_else(|| self.file.clone(), |point| self.place(point));
        let text = format!("{place}: {}{hint}{}", self.renumber(error), self.hint());
        if is_refused {
            Failure::BadInput(text)
        } else if is_usage {
            Failure::Usage(text)
        } else {
            Failure::NotReached(text)
        }
    }

    /// Says what deserves a word though the result is right.
    pub fn notes(&self, result: &ConstrainedTriangulation) -> Vec<String> {
        let warnings = result.warnings().iter();
        warnings.map(|warning| self.note(warning)).collect()
    }

    fn note(&self, warning: &Warning) -> String {
        let base = self.base;
        let renumbered = match *warning {
            Warning::HoleOutside { hole, at } => Warning::HoleOutside {
                hole: hole + base,
                at,
            },
            Warning::RegionOutside { region, at } => Warning::RegionOutside {
                region: region + base,
                at,
            },
            Warning::RegionTwice { region, first } => Warning::RegionTwice {
                region: region + base,
                first: first + base,
            },
            _ => return format!("{}: {warning}", self.file),
        };
        format!("{}: {renumbered}{}", self.file, self.hint())
    }

    /// Returns the name of the file.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Returns the line of a point, counted from 1, if it has one; `point` counts from 0.
    pub fn line(&self, point: usize) -> Option<u64> {
        self.lines.of(point)
    }

    /// Returns the name of the file, with the line of a point if it has one; `point` counts from 0.
    pub fn place(&self, point: usize) -> String {
        match self.line(point) {
            Some(line) => format!("{}:{line}", self.file),
            None => self.file.clone(),
        }
    }

    /// Returns the number of the first point, segment, hole and region.
    pub fn base(&self) -> usize {
        self.base
    }

    /// Returns what is to be added where numbers of the file are named.
    pub fn hint(&self) -> &str {
        if self.base == 1 {
            " (numbered from 1)"
        } else {
            ""
        }
    }

    fn renumber(&self, error: Error) -> Error {
        let base = self.base;
        match error {
            Error::NotFinite { index, x, y } => Error::NotFinite {
                index: index + base,
                x,
                y,
            },
            Error::Crossing { segments, at } => Error::Crossing {
                segments: segments.map(|s| s + base),
                at,
            },
            Error::BadArea { region, max_area } => Error::BadArea {
                region: region + base,
                max_area,
            },
            Error::BadSize { index, given } => Error::BadSize {
                index: index + base,
                given,
            },
            Error::BadWeight { index, weight } => Error::BadWeight {
                index: index + base,
                weight,
            },
            Error::WeightNotPositive { index, weight } => Error::WeightNotPositive {
                index: index + base,
                weight,
            },
            Error::ValueNotFinite {
                vertex,
                given,
                what,
            } => Error::ValueNotFinite {
                vertex: VertexId::new(vertex.index() + base),
                given,
                what,
            },
            Error::ValuesDiffer { vertices, values } => Error::ValuesDiffer {
                vertices: vertices.map(|v| VertexId::new(v.index() + base)),
                values,
            },
            Error::DatumOutside { datum, at } => Error::DatumOutside {
                datum: datum + base,
                at,
            },
            Error::BadTriangle {
                triangle,
                vertex,
                points,
            } => Error::BadTriangle {
                triangle: triangle + base,
                vertex: VertexId::new(vertex.index() + base),
                points,
            },
            Error::BadStart { triangle, why } => Error::BadStart {
                triangle: triangle + base,
                why,
            },
            Error::SameSide { triangles, edge } => Error::SameSide {
                triangles: triangles.map(|t| t + base),
                edge: edge.map(|v| VertexId::new(v.index() + base)),
            },
            Error::SeedNotFinite { seed, at } => Error::SeedNotFinite {
                seed: self.renumber_seed(seed),
                at,
            },
            Error::SeedOnSegment { seed, at, segment } => Error::SeedOnSegment {
                seed: self.renumber_seed(seed),
                at,
                segment: segment + base,
            },
            other => other,
        }
    }

    fn renumber_seed(&self, seed: Seed) -> Seed {
        match seed {
            Seed::Hole(i) => Seed::Hole(i + self.base),
            Seed::Region(i) => Seed::Region(i + self.base),
        }
    }
}

/// Returns the point that is at fault, if one is.
fn culprit(error: &Error) -> Option<usize> {
    match *error {
        Error::NotFinite { index, .. }
        | Error::BadSize { index, .. }
        | Error::BadWeight { index, .. }
        | Error::WeightNotPositive { index, .. } => Some(index),
        Error::DatumOutside { datum, .. } => Some(datum),
        Error::ValueNotFinite { vertex, .. } => Some(vertex.index()),
        Error::ValuesDiffer { vertices, .. } => Some(vertices[1].index()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::Point;

    fn numbering(base: usize) -> Numbering {
        Numbering {
            file: "k.poly".to_owned(),
            base,
            lines: Lines::default(),
            about_crossings: "--crossings split",
        }
    }

    #[test]
    fn crossings_are_named_as_the_file_counts() {
        let at = Point::new(0.5, 2.0);
        let crossing = Error::Crossing {
            segments: [3, 17],
            at,
        };
        let said = |base| match numbering(base).failure(crossing.clone()) {
            Failure::BadInput(text) => text,
            other => panic!("{other}"),
        };
        assert!(said(0).starts_with("k.poly: segments 3 and 17 cross at (0.5, 2)"));
        assert!(said(0).ends_with("--crossings split"));
        assert!(said(1).starts_with("k.poly: segments 4 and 18 cross at (0.5, 2)"));
        assert!(said(1).ends_with("(numbered from 1)"));
    }

    #[test]
    fn seeds_and_warnings_are_renumbered() {
        let at = Point::new(1.0, 1.0);
        let error = Error::SeedOnSegment {
            seed: Seed::Hole(0),
            at,
            segment: 4,
        };
        let said = numbering(1).failure(error).to_string();
        assert!(
            said.contains("hole 1 at (1, 1) lies on segment 5"),
            "{said}"
        );
        let error = Error::BadArea {
            region: 0,
            max_area: -1.0,
        };
        let said = numbering(1).failure(error);
        assert!(matches!(&said, Failure::BadInput(text) if text.contains("region 1 is -1")));
        let said = numbering(1).note(&Warning::RegionTwice {
            region: 2,
            first: 0,
        });
        assert!(said.contains("region 3 lies in the region of 1"), "{said}");
        assert!(
            numbering(1)
                .note(&Warning::Empty)
                .starts_with("k.poly: nothing")
        );
    }

    #[test]
    fn triangles_are_named_as_the_file_counts() {
        let [a, b] = [3, 4].map(VertexId::new);
        for (error, words) in [
            (
                Error::BadTriangle {
                    triangle: 0,
                    vertex: b,
                    points: 4,
                },
                "triangle 1 names point 5",
            ),
            (
                Error::BadStart {
                    triangle: 6,
                    why: "it is there twice",
                },
                "triangle 7 cannot",
            ),
            (
                Error::SameSide {
                    triangles: [0, 2],
                    edge: [a, b],
                },
                "triangles 1 and 3 lie on the same side of the edge from point 4 to point 5",
            ),
        ] {
            let said = numbering(1).failure(error);
            let is_right = matches!(&said, Failure::BadInput(text) if text.contains(words));
            assert!(is_right, "{said}");
        }
        let not_taken = Error::NotTaken {
            algorithm: "sweep",
            what: "segments",
        };
        let said = numbering(0).failure(not_taken);
        assert!(matches!(said, Failure::Usage(_)), "{said}");
    }

    #[test]
    fn limits_are_not_the_fault_of_the_input() {
        let error = Error::TooManyPoints { given: 5, limit: 4 };
        assert!(matches!(
            numbering(0).failure(error),
            Failure::NotReached(_)
        ));
        assert!(matches!(
            numbering(0).failure(Error::Cancelled),
            Failure::Cancelled
        ));
    }
}
