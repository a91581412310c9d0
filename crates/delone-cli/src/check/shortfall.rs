//! How a right mesh compares with what was asked of it, in words and for programs.

use crate::words::{counted, list, measure};
use delone::check::{Counts, Encroached, Excuse, QualityVerdict, Unmet};
use delone_io::MeshData;
use serde::Serialize;
use std::fmt;

/// Most triangles and most subsegments that are named.
const NAMED: usize = 8;

/// What is missing; the fields are keys of `--json`.
#[derive(Serialize)]
pub struct Shortfall {
    met: bool,
    unmet: usize,
    unexcused: usize,
    unmet_by_reason: ByReason,
    encroached: usize,
    encroached_unexcused: usize,
    steiner_on_locked: usize,
    worst: Vec<String>,
}

/// How many triangles have which excuse.
#[derive(Serialize)]
struct ByReason {
    small_input_angle: usize,
    locked_boundary: usize,
    precision: usize,
}

impl Shortfall {
    /// Sums up a verdict on a mesh, and names the worst.
    pub fn new(verdict: &QualityVerdict, mesh: &MeshData) -> Self {
        let Counts {
            unexcused,
            small_input_angle,
            locked,
            precision,
        } = verdict.counts();
        let unmet = verdict.unmet.iter().map(|unmet| self::unmet(unmet, mesh));
        let encroached = verdict.encroached.iter();
        let on_locked = verdict.on_locked.iter();
        let on_locked = on_locked.map(|v| {
            let at = mesh.vertices.points[v.index()];
            format!(
                "vertex {v} ({:?}, {:?}) was added on a segment that had to stay as it was",
                at.x, at.y
            )
        });
        Self {
            met: verdict.is_met(),
            unmet: verdict.unmet.len(),
            unexcused,
            unmet_by_reason: ByReason {
                small_input_angle,
                locked_boundary: locked,
                precision,
            },
            encroached: verdict.encroached.len(),
            encroached_unexcused: encroached.clone().filter(|e| e.excuse.is_none()).count(),
            steiner_on_locked: verdict.on_locked.len(),
            worst: (unmet.take(NAMED))
                .chain(encroached.map(self::encroached).take(NAMED))
                .chain(on_locked.take(NAMED))
                .collect(),
        }
    }

    /// Tells whether all that was asked for is there, or has an excuse.
    pub fn is_met(&self) -> bool {
        self.met
    }

    /// Tells whether triangles are named by their numbers.
    pub fn names_any(&self) -> bool {
        !self.worst.is_empty()
    }
}

/// Says what a triangle breaks, and why.
fn unmet(unmet: &Unmet, mesh: &MeshData) -> String {
    let longest = unmet.shape.edges.into_iter().fold(0.0, f64::max);
    let broken = unmet.broken;
    let parts: Vec<String> = [
        (
            broken.angle,
            format!("an angle of {}°", measure(unmet.shape.min_angle())),
        ),
        (
            broken.edge,
            format!("an edge of length {}", measure(longest)),
        ),
        (
            broken.area,
            format!("an area of {}", measure(unmet.shape.area)),
        ),
    ]
    .into_iter()
    .filter_map(|(is_broken, part)| is_broken.then_some(part))
    .collect();
    let triangle = unmet.triangle.raw();
    let first = mesh.triangles[unmet.triangle.index()][0];
    let at = mesh.vertices.points[first.index()];
    let (x, y) = (measure(at.x), measure(at.y));
    let excuse = excuse(unmet.excuse);
    format!(
        "triangle {triangle} at ({x}, {y}) has {}: {excuse}",
        list(&parts)
    )
}

fn encroached(encroached: &Encroached) -> String {
    let ([a, b], apex) = (encroached.edge, encroached.apex);
    let excuse = excuse(encroached.excuse);
    format!("vertex {apex} lies in the diametral circle of subsegment {a} – {b}: {excuse}")
}

fn excuse(excuse: Option<Excuse>) -> String {
    match excuse {
        Some(Excuse::SmallInputAngle {
            vertex,
            segments: [a, b],
            angle,
        }) => {
            let angle = measure(angle.to_degrees());
            format!("excused by the {angle}° between segments {a} and {b} at vertex {vertex}")
        }
        Some(Excuse::Locked) => "excused by a segment that had to stay as it was".to_owned(),
        Some(Excuse::Precision) => "excused, coordinates have no room for more vertices".to_owned(),
        _ => "nothing excuses it".to_owned(),
    }
}

impl fmt::Display for Shortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "bounds {}", if self.met { "met" } else { "NOT met" })?;
        let by = &self.unmet_by_reason;
        for (n, words) in [
            (self.unexcused, "without an excuse"),
            (by.small_input_angle, "excused by small angles of the input"),
            (by.locked_boundary, "excused by segments that had to stay"),
            (by.precision, "excused by the precision of coordinates"),
        ] {
            if n > 0 {
                let triangles = counted(n, "triangle", "triangles");
                write!(f, "; {triangles} beyond them {words}")?;
            }
        }
        if self.encroached > 0 {
            let subsegments = counted(self.encroached, "subsegment", "subsegments");
            let unexcused = self.encroached_unexcused;
            write!(
                f,
                "; {subsegments} encroached upon, {unexcused} of them without an excuse"
            )?;
        }
        if self.steiner_on_locked > 0 {
            let vertices = counted(self.steiner_on_locked, "vertex", "vertices");
            write!(f, "; {vertices} added on segments that had to stay")?;
        }
        for worst in &self.worst {
            write!(f, "\n  - {worst}")?;
        }
        Ok(())
    }
}
