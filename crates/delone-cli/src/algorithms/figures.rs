//! What a run has come to: counts, hash, whether the result is the canonical one, and what went wrong.

mod failed;

use crate::words::{count, counted};
use delone::classic::{About, Output};
use delone::{ConstrainedDelaunay, Error, Pslg, Tally, VertexId, Watch};
use failed::Failed;
use serde::Serialize;
use std::collections::HashSet;

/// The figures of a run; the fields are the keys of `--json`.
#[derive(Serialize)]
pub struct Figures {
    algorithm: &'static str,
    points: usize,
    duplicates: usize,
    vertices_added: usize,
    triangles: usize,
    constrained_edges: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    hull: Vec<usize>,
    hash: String,
    is_canonical: bool,
    #[serde(skip)]
    claims_delaunay: bool,
    failures: Vec<Failed>,
    statistics: Statistics,
}

/// What was done.
#[derive(Serialize)]
struct Statistics {
    orientation_tests: u64,
    circle_tests: u64,
    ties: u64,
    flips: u64,
    walk_steps: u64,
    pushed: u64,
    edges_created: u64,
    edges_deleted: u64,
    first_conflicts: Option<u64>,
    last_conflicts: Option<u64>,
    steps: u64,
}

impl From<&Tally> for Statistics {
    fn from(tally: &Tally) -> Self {
        Self {
            orientation_tests: tally.orientation_tests,
            circle_tests: tally.circle_tests,
            ties: tally.ties,
            flips: tally.flips,
            walk_steps: tally.walk_steps,
            pushed: tally.pushed,
            edges_created: tally.edges_created,
            edges_deleted: tally.edges_deleted,
            first_conflicts: tally.first_conflicts,
            last_conflicts: tally.last_conflicts,
            steps: tally.steps,
        }
    }
}

impl Figures {
    /// Counts.
    pub fn of(
        about: &About,
        given: usize,
        output: &Output,
        tally: &Tally,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        Ok(Self {
            algorithm: about.name,
            points: given,
            duplicates: output.duplicates.len(),
            vertices_added: output.points.len() - given,
            triangles: output.triangles.len(),
            constrained_edges: output.constrained.len(),
            hull: output.hull.iter().map(|v| v.index()).collect(),
            hash: output.hash().to_string(),
            is_canonical: is_canonical(output, watch)?,
            claims_delaunay: about.is_delaunay,
            failures: output.failures.iter().map(Failed::from).collect(),
            statistics: tally.into(),
        })
    }

    /// Says them to people.
    pub fn lines(&self) -> Vec<String> {
        let Statistics {
            orientation_tests,
            circle_tests,
            ties,
            flips,
            walk_steps,
            steps,
            first_conflicts,
            last_conflicts,
            ..
        } = &self.statistics;
        let [points, triangles] = [
            counted(self.points, "point", "points"),
            counted(self.triangles, "triangle", "triangles"),
        ];
        let canonical = match (self.is_canonical, self.claims_delaunay) {
            _ if self.triangles == 0 => "",
            (true, true) => ", the canonical Delaunay triangulation",
            (true, false) => ", all of the canonical Delaunay triangulation",
            (false, _) => ", not Delaunay",
        };
        let hull = match self.hull.len() {
            0 => String::new(),
            n => format!(", {n} on the hull"),
        };
        let mut lines = vec![
            format!("{}: {points}{hull}, {triangles}{canonical}", self.algorithm),
            format!(
                "{}, {} ({}), {}, {}, {} in all",
                counted(
                    *orientation_tests as usize,
                    "orientation test",
                    "orientation tests"
                ),
                counted(*circle_tests as usize, "circle test", "circle tests"),
                counted(*ties as usize, "tie", "ties"),
                counted(*flips as usize, "flip", "flips"),
                counted(*walk_steps as usize, "walk step", "walk steps"),
                counted(*steps as usize, "step", "steps"),
            ),
        ];
        if let (Some(first), Some(last)) = (first_conflicts, last_conflicts) {
            let [first, last] = [first, last].map(|phi| count(*phi as usize));
            lines.push(format!(
                "Φ, the pairs of a triangle and a point in its circle: {first}, then {last}"
            ));
        }
        lines.extend(failed::line(&self.failures));
        lines.push(format!("hash {}", self.hash));
        lines
    }
}

/// Tells whether every triangle is one of the canonical constrained Delaunay triangulation of vertices and
/// constrained edges.
fn is_canonical(output: &Output, watch: &dyn Watch) -> Result<bool, Error> {
    let pslg = Pslg {
        points: output.points.clone(),
        segments: output.constrained.clone(),
        ..Pslg::default()
    };
    let builder = ConstrainedDelaunay::new().threads(1).watch(watch);
    let all = builder.triangulate(pslg)?;
    let mesh = all.triangulation();
    let all: HashSet<_> = mesh
        .triangles()
        .iter()
        .copied()
        .map(smallest_first)
        .collect();
    let name = |t: [VertexId; 3]| smallest_first(t.map(|v| mesh.representative(v)));
    Ok(output.triangles.iter().all(|&t| all.contains(&name(t))))
}

fn smallest_first(mut corners: [VertexId; 3]) -> [VertexId; 3] {
    let k = (0..3).min_by_key(|&k| corners[k]);
    corners.rotate_left(k.unwrap_or(0));
    corners
}
