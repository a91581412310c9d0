//! What can be wrong with points and segments, in the numbers of their file.

use crate::words::counted;
use delone::Point;
use serde::Serialize;
use std::fmt;

/// Trouble of one kind: how much of it there is, and the first few cases.
#[derive(Serialize)]
pub struct Listed<T> {
    pub total: u64,
    pub listed: Vec<T>,
}

impl<T> Listed<T> {
    /// Describes what has been found.
    pub fn of<F: Copy>(found: &delone::Listed<F>, describe: impl FnMut(F) -> T) -> Self {
        Self {
            total: found.count,
            listed: found.first.iter().copied().map(describe).collect(),
        }
    }
}

impl<T: fmt::Display> Listed<T> {
    /// Writes the total as a heading, and below it what is listed; nothing if there is none.
    pub fn write(&self, f: &mut fmt::Formatter<'_>, one: &str, many: &str) -> fmt::Result {
        if self.total == 0 {
            return Ok(());
        }
        let total = self.total as usize;
        let end = if self.listed.is_empty() { "" } else { ":" };
        writeln!(f, "  {}{end}", counted(total, one, many))?;
        for case in &self.listed {
            writeln!(f, "    {case}")?;
        }
        match total - self.listed.len() {
            more if more > 0 && !self.listed.is_empty() => {
                writeln!(
                    f,
                    "    and {} (see --limit)",
                    counted(more, "other", "others")
                )
            }
            _ => Ok(()),
        }
    }
}

/// A place, written so that it reads back as the same.
#[derive(Clone, Copy, Serialize)]
#[serde(transparent)]
pub struct Place(pub [f64; 2]);

impl From<Point> for Place {
    fn from(p: Point) -> Self {
        Self(p.into())
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.0;
        write!(f, "({x:?}, {y:?})")
    }
}

/// A point equal to an earlier one.
#[derive(Serialize)]
pub struct Duplicate {
    pub point: usize,
    pub equals: usize,
    pub at: Place,
}

impl fmt::Display for Duplicate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "point {} equals {} at {}",
            self.point, self.equals, self.at
        )
    }
}

/// A point that ends one segment, or none.
#[derive(Serialize)]
pub struct End {
    pub point: usize,
    pub at: Place,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "point {} at {}", self.point, self.at)
    }
}

/// A segment of no length.
#[derive(Serialize)]
pub struct ZeroLength {
    pub segment: usize,
    pub at: Place,
}

impl fmt::Display for ZeroLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "segment {} at {}", self.segment, self.at)
    }
}

/// A segment equal to an earlier one.
#[derive(Serialize)]
pub struct Repeated {
    pub segment: usize,
    pub equals: usize,
    pub ends: [Place; 2],
}

impl fmt::Display for Repeated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = self.ends;
        write!(
            f,
            "segment {} equals {}: {from} – {to}",
            self.segment, self.equals
        )
    }
}

/// A point inside a segment.
#[derive(Serialize)]
pub struct OnSegment {
    pub point: usize,
    pub segment: usize,
    pub at: Place,
}

impl fmt::Display for OnSegment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "point {} on segment {} at {}",
            self.point, self.segment, self.at
        )
    }
}

/// Two segments that have more than a point in common.
#[derive(Serialize)]
pub struct Overlap {
    pub segments: [usize; 2],
    /// Of what they have in common.
    pub ends: [Place; 2],
}

impl fmt::Display for Overlap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([s, t], [from, to]) = (self.segments, self.ends);
        write!(f, "segments {s} and {t} from {from} to {to}")
    }
}

/// Two segments that cross.
#[derive(Serialize)]
pub struct Crossing {
    pub segments: [usize; 2],
    pub at: Place,
}

impl fmt::Display for Crossing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [s, t] = self.segments;
        write!(f, "segments {s} and {t} at {}", self.at)
    }
}

/// A ring of segments.
#[derive(Serialize)]
pub struct Ring {
    /// Its first segment, which names it.
    pub segment: usize,
    pub segments: usize,
    /// How many rings are around it.
    pub depth: usize,
    /// The first segment of the ring directly around it.
    pub inside: Option<usize>,
}

impl fmt::Display for Ring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let segments = counted(self.segments, "segment", "segments");
        write!(f, "ring of segment {}: {segments}", self.segment)?;
        match self.inside {
            Some(around) => write!(f, ", inside the ring of segment {around}"),
            None => Ok(()),
        }
    }
}
