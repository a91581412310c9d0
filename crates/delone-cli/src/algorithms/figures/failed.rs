//! Where an algorithm goes wrong that is replayed as it was printed.

use crate::words::{counted, list};
use delone::{Failure, VertexId};
use serde::Serialize;

/// What goes wrong, and at which vertices, from 0.
#[derive(Serialize)]
pub struct Failed {
    kind: Kind,
    vertices: Vec<usize>,
}

#[derive(Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    SeesNothing,
    SeesOne,
    SeesSeveralRuns,
    SegmentLost,
    Overlaps,
    Other,
}

/// The kinds, in words for one and for several.
const KINDS: [(Kind, &str, &str); 6] = [
    (
        Kind::SeesNothing,
        "point that sees nothing",
        "points that see nothing",
    ),
    (
        Kind::SeesOne,
        "point that sees one vertex",
        "points that see one vertex",
    ),
    (
        Kind::SeesSeveralRuns,
        "point that sees several runs",
        "points that see several runs",
    ),
    (Kind::SegmentLost, "segment lost", "segments lost"),
    (
        Kind::Overlaps,
        "triangle upon others",
        "triangles upon others",
    ),
    (Kind::Other, "other failure", "other failures"),
];

impl From<&Failure> for Failed {
    fn from(failure: &Failure) -> Self {
        let (kind, vertices): (_, &[VertexId]) = match failure {
            Failure::SeesNothing(v) => (Kind::SeesNothing, &[*v]),
            Failure::SeesOne(v) => (Kind::SeesOne, &[*v]),
            Failure::SeesSeveralRuns(v) => (Kind::SeesSeveralRuns, &[*v]),
            Failure::SegmentLost(ends) => (Kind::SegmentLost, ends),
            Failure::Overlaps(corners) => (Kind::Overlaps, corners),
            _ => (Kind::Other, &[]),
        };
        Self {
            kind,
            vertices: vertices.iter().map(|v| v.index()).collect(),
        }
    }
}

/// Says how often what goes wrong, if anything does.
pub fn line(failures: &[Failed]) -> Option<String> {
    let number = |kind| failures.iter().filter(|f| f.kind == kind).count();
    let kinds = KINDS.map(|(kind, one, many)| (number(kind), one, many));
    let kinds = kinds.iter().filter(|(n, ..)| *n > 0);
    let words: Vec<String> = kinds.map(|&(n, one, many)| counted(n, one, many)).collect();
    (!words.is_empty()).then(|| format!("as printed it fails: {}", list(&words)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_counted() {
        let [a, b, c] = [4, 5, 6].map(VertexId::new);
        let failures = [
            Failure::SegmentLost([a, b]),
            Failure::SeesNothing(c),
            Failure::SegmentLost([b, c]),
        ];
        let failed: Vec<Failed> = failures.iter().map(Failed::from).collect();
        let said = "as printed it fails: 1 point that sees nothing and 2 segments lost";
        assert_eq!(line(&failed).as_deref(), Some(said));
        let json = serde_json::to_string(&failed[0]).expect("JSON");
        assert_eq!(json, r#"{"kind":"segment-lost","vertices":[4,5]}"#);
        assert_eq!(line(&[]), None);
    }
}
