//! What a cover comes to: the figures that the checker has found, who trusts no builder.

use super::histogram;
use crate::exit::Failure;
use crate::words::{counted, list};
use delone::check::CoverCertificate;
use delone::scattered::{Cause, DataTriangulation, Exception};
use delone::{Error, Point, VertexId, Watch};
use serde::Serialize;
use std::collections::BTreeMap;

/// Special cases that are told one by one to people.
const TOLD: usize = 5;

/// The figures; the fields are the keys of `--json`.
#[derive(Serialize)]
pub struct Found {
    data: usize,
    duplicates: usize,
    vertices: usize,
    triangles: usize,
    least: usize,
    most: usize,
    data_per_triangle: PerTriangle,
    /// Numbers of data, and of triangles that hold so many.
    histogram: Vec<[usize; 2]>,
    data_covered: usize,
    too_full: usize,
    special_cases: Vec<SpecialCase>,
    min_angle_degrees: f64,
    area: f64,
    outline: Vec<Point>,
    hash: String,
    /// The number of the first triangle and vertex.
    #[serde(skip)]
    pub base: usize,
}

#[derive(Serialize)]
struct PerTriangle {
    min: usize,
    max: usize,
    mean: f64,
}

/// A triangle that holds too many data, and why none can help it.
#[derive(Serialize)]
struct SpecialCase {
    triangle: usize,
    corners: [usize; 3],
    places: [Point; 3],
    data: usize,
    cause: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    edge: Option<[usize; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    corner: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    data_on_edges: Option<usize>,
}

impl Found {
    /// Has the checker prove it right; triangles and vertices are numbered from `base` on.
    pub fn of(cover: &DataTriangulation, base: usize, watch: &dyn Watch) -> Result<Self, Failure> {
        let verdict = cover.verify(watch);
        let verdict = verdict.map_err(|error| match error {
            Error::Cancelled => Failure::Cancelled,
            other => Failure::NotReached(other.to_string()),
        })?;
        match verdict.into_result() {
            Ok(certificate) => Ok(Self::certified(cover, certificate, base)),
            Err(defects) => Err(Failure::NotReached(format!(
                "bug: the triangulation made is wrong, and nothing has been written: {defects}"
            ))),
        }
    }

    fn certified(cover: &DataTriangulation, certificate: CoverCertificate, base: usize) -> Self {
        let histogram = certificate.histogram.into_iter().enumerate();
        let special = |exception| SpecialCase::of(exception, cover, base);
        let outline = outline(cover.triangles()).into_iter();
        Self {
            data: cover.num_data(),
            duplicates: certificate.duplicates,
            vertices: certificate.vertices,
            triangles: certificate.triangles,
            least: cover.least(),
            most: cover.most(),
            data_per_triangle: PerTriangle {
                min: certificate.fewest,
                max: certificate.most,
                mean: certificate.mean,
            },
            histogram: histogram
                .filter(|&(_, often)| often > 0)
                .map(Into::into)
                .collect(),
            data_covered: certificate.data,
            too_full: certificate.special.len(),
            special_cases: cover.exceptions().iter().filter_map(special).collect(),
            min_angle_degrees: certificate.min_angle,
            area: certificate.area,
            outline: outline.map(|v| cover.points()[v.index()]).collect(),
            hash: certificate.hash.to_string(),
            base,
        }
    }

    /// Says it to people.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = vec![self.counts()];
        let PerTriangle { min, max, mean } = self.data_per_triangle;
        lines.push(format!(
            "data in a triangle: {min} to {max}, mean {mean:.1}; asked for were {} to {}",
            self.least, self.most
        ));
        lines.extend(histogram::lines(&self.histogram));
        let special = self.special_cases.len();
        if self.too_full > special {
            let too_full = counted(self.too_full - special, "triangle holds", "triangles hold");
            lines.push(format!("{too_full} more than {}", self.most));
        }
        let told = self.special_cases.iter().take(TOLD);
        lines.extend(told.map(SpecialCase::in_words));
        if special > TOLD {
            let rest = counted(special - TOLD, "special case", "special cases");
            lines.push(format!("{rest} more; --json names all"));
        }
        lines
    }

    fn counts(&self) -> String {
        let duplicates = match self.duplicates {
            0 => String::new(),
            n => format!(" ({})", counted(n, "duplicate", "duplicates")),
        };
        format!(
            "{}{duplicates} in {} over {}",
            counted(self.data, "datum", "data"),
            counted(self.triangles, "triangle", "triangles"),
            counted(self.vertices, "vertex", "vertices")
        )
    }
}

impl SpecialCase {
    /// `None`: nobody tried to divide it.
    fn of(exception: &Exception, cover: &DataTriangulation, base: usize) -> Option<Self> {
        let number = |v: VertexId| v.index() + base;
        let triangle = cover.triangles()[exception.triangle.index()];
        let (cause, edge, corner, on_edges) = match exception.cause {
            Cause::Edge { edge, data } => ("edge", Some(edge.map(number)), None, Some(data)),
            Cause::TwoEdges { corner, data } => {
                ("two-edges", None, Some(number(corner)), Some(data))
            }
            Cause::Resolution => ("resolution", None, None, None),
            Cause::Untried => return None,
        };
        Some(Self {
            triangle: exception.triangle.index() + base,
            corners: triangle.map(number),
            places: corners(cover, triangle),
            data: exception.data,
            cause,
            edge,
            corner,
            data_on_edges: on_edges,
        })
    }

    fn in_words(&self) -> String {
        let why = match (self.edge, self.corner, self.data_on_edges) {
            (Some([a, b]), _, Some(data)) => {
                format!("{data} of them on the edge from vertex {a} to {b}")
            }
            (_, Some(corner), Some(data)) => {
                format!("{data} of them on the two edges at vertex {corner}")
            }
            _ => "and no point of double precision was found that divides it".to_owned(),
        };
        let Self { triangle, data, .. } = self;
        let corners = list(&self.corners.map(|v| v.to_string()));
        format!("special case: triangle {triangle} (vertices {corners}) holds {data}, {why}")
    }
}

fn corners(cover: &DataTriangulation, triangle: [VertexId; 3]) -> [Point; 3] {
    triangle.map(|v| cover.points()[v.index()])
}

/// Lists the vertices of the border once around, from the one of lowest number.
fn outline(triangles: &[[VertexId; 3]]) -> Vec<VertexId> {
    let sides = |&[a, b, c]: &[VertexId; 3]| [[a, b], [b, c], [c, a]];
    let mut edges: Vec<[VertexId; 2]> = triangles.iter().flat_map(sides).collect();
    edges.sort_unstable();
    let is_border = |&&[a, b]: &&[VertexId; 2]| edges.binary_search(&[b, a]).is_err();
    let next: BTreeMap<_, _> = edges
        .iter()
        .filter(is_border)
        .map(|&[a, b]| (a, b))
        .collect();
    let Some((&first, _)) = next.first_key_value() else {
        return Vec::new();
    };
    let after = |v: &VertexId| next.get(v).copied().filter(|&v| v != first);
    // A border that is one ring ends by itself.
    let ring = std::iter::successors(Some(first), after);
    ring.take(next.len()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_is_followed_counter_clockwise() {
        let square = [[3, 1, 2], [3, 2, 5], [3, 5, 4], [3, 4, 1]].map(|t| t.map(VertexId::new));
        assert_eq!(outline(&square), [1, 2, 5, 4].map(VertexId::new));
        assert_eq!(outline(&square[..2]), [1, 2, 5, 3].map(VertexId::new));
        assert!(outline(&[]).is_empty());
    }

    #[test]
    fn all_data_are_looked_at_once() {
        let lattice = (0..100).map(|i| (f64::from(i % 10), f64::from(i / 10)));
        let twice = lattice.clone().chain(lattice.take(7));
        let cover = delone::scattered::cover(twice, 5).expect("enough data");
        let found = Found::of(&cover, 1, &()).expect("right");
        assert_eq!(
            [found.data, found.duplicates, found.data_covered],
            [100, 7, 100]
        );
        let all: usize = found
            .histogram
            .iter()
            .map(|[count, often]| count * often)
            .sum();
        assert_eq!(all, 100);
        let sum = found.data_per_triangle.mean * found.triangles as f64;
        assert!((sum - 100.0).abs() < 1e-9);
    }
}
