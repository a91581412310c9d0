//! What a cover comes to: its figures, and a second look at who holds what.

use super::histogram;
use crate::words::{counted, list};
use delone::predicates::{Orientation, orient2d};
use delone::scattered::{Cause, DataTriangulation, Exception};
use delone::{Duplicate, Point, TriangleId, VertexId, hash_triangles};
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
    /// Counts; triangles and vertices are numbered from `base` on.
    pub fn of(cover: &DataTriangulation, base: usize) -> Self {
        let held = cover.counts();
        let mut histogram = BTreeMap::new();
        for &count in &held {
            *histogram.entry(count).or_insert(0) += 1;
        }
        let histogram: Vec<[usize; 2]> = histogram.into_iter().map(Into::into).collect();
        let [min, max] = [histogram.first(), histogram.last()];
        let [min, max] = [min, max].map(|pair| pair.map_or(0, |[count, _]| *count));
        let special = |exception| SpecialCase::of(exception, cover, base);
        Self {
            data: cover.num_data(),
            duplicates: cover.duplicates().len(),
            vertices: cover.points().len(),
            triangles: held.len(),
            least: cover.least(),
            most: cover.most(),
            data_per_triangle: PerTriangle {
                min,
                max,
                mean: cover.num_data() as f64 / held.len().max(1) as f64,
            },
            histogram,
            data_covered: covered(cover),
            too_full: held.iter().filter(|&&count| count > cover.most()).count(),
            special_cases: cover.exceptions().iter().map(special).collect(),
            outline: outline(cover.triangles())
                .into_iter()
                .map(|v| cover.points()[v.index()])
                .collect(),
            hash: hash_triangles(cover.triangles().iter().map(|&t| corners(cover, t))).to_string(),
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
    fn of(exception: &Exception, cover: &DataTriangulation, base: usize) -> Self {
        let number = |v: VertexId| v.index() + base;
        let triangle = cover.triangles()[exception.triangle.index()];
        let (cause, edge, corner, on_edges) = match exception.cause {
            Cause::Edge { edge, data } => ("edge", Some(edge.map(number)), None, Some(data)),
            Cause::TwoEdges { corner, data } => {
                ("two-edges", None, Some(number(corner)), Some(data))
            }
            Cause::Resolution => ("resolution", None, None, None),
        };
        Self {
            triangle: exception.triangle.index() + base,
            corners: triangle.map(number),
            places: corners(cover, triangle),
            data: exception.data,
            cause,
            edge,
            corner,
            data_on_edges: on_edges,
        }
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

/// Counts the different data that lie in the triangle that holds them, boundary included, by the exact signs.
fn covered(cover: &DataTriangulation) -> usize {
    let mut is_duplicate = vec![false; cover.data().len()];
    for Duplicate { dropped, .. } in cover.duplicates() {
        is_duplicate[dropped.index()] = true;
    }
    let holds = |(&p, &t): (&Point, &TriangleId)| {
        let [a, b, c] = corners(cover, cover.triangles()[t.index()]);
        let sides = [[a, b], [b, c], [c, a]];
        sides
            .iter()
            .all(|&[from, to]| orient2d(from, to, p) != Orientation::Right)
    };
    let data = cover.data().iter().zip(cover.holders());
    let different = data
        .zip(is_duplicate)
        .filter(|(_, is_duplicate)| !is_duplicate);
    different.filter(|&(datum, _)| holds(datum)).count()
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
        let found = Found::of(&cover, 1);
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
