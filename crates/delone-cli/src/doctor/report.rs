//! What the doctor has found and done, for people and for programs.

use super::meaning;
use super::{Describer, Patient, name_of};
use crate::memory::peak_rss_bytes;
use crate::words::{counted, duration, measure};
use delone::doctor::{Diagnosis, Kind, Severity};
use serde::Serialize;
use std::fmt;
use std::time::Duration;

/// The fields are the keys of `--json`, in this order.
#[derive(Serialize)]
pub struct Report {
    file: String,
    base: usize,
    points: usize,
    segments: usize,
    tolerance: f64,
    healthy: bool,
    errors: u64,
    warnings: u64,
    notes: u64,
    suggestion: Option<f64>,
    sharpest: Option<f64>,
    corners_below_60: u64,
    domain_known: bool,
    troubles: Vec<Group>,
    repair: Option<RepairReport>,
    seconds: Seconds,
    peak_rss_bytes: Option<u64>,
}

/// The troubles of one kind.
#[derive(Serialize)]
pub struct Group {
    kind: &'static str,
    severity: &'static str,
    total: u64,
    listed: Vec<Case>,
    #[serde(skip)]
    words: [&'static str; 3],
}

/// One trouble.
#[derive(Serialize)]
struct Case {
    number: usize,
    text: String,
    points: Vec<usize>,
    segments: Vec<usize>,
    polygon: Option<usize>,
    seeds: Vec<String>,
    at: Option<[f64; 2]>,
    to: Option<[f64; 2]>,
    size: Option<f64>,
}

/// How many there are, and the first of them.
#[derive(Serialize)]
pub struct Listed<T> {
    total: usize,
    listed: Vec<T>,
}

impl<T> Listed<T> {
    pub fn of(all: impl Iterator<Item = T>, limit: usize) -> Self {
        let (mut total, mut listed) = (0, Vec::new());
        for one in all {
            total += 1;
            if listed.len() < limit {
                listed.push(one);
            }
        }
        Self { total, listed }
    }
}

/// What a repair has changed.
#[derive(Serialize)]
pub struct RepairReport {
    pub file: String,
    pub points: usize,
    pub segments: usize,
    pub rounds: usize,
    pub settled: bool,
    /// The largest distance that a point has moved.
    pub largest: f64,
    /// Point, from, at, distance.
    pub moved: Listed<(usize, [f64; 2], [f64; 2], f64)>,
    /// Point, and the one that it became.
    pub merged: Listed<[usize; 2]>,
    /// Segment, through where, and how far that is from it.
    pub split: Listed<(usize, [f64; 2], f64)>,
    /// Two segments, and where they were cut.
    pub cuts: Listed<([usize; 2], [f64; 2])>,
    pub vanished: Listed<usize>,
    pub doubled: Listed<usize>,
    pub closed: u64,
    /// Merged points whose attributes or markers are lost.
    pub dropped: usize,
    pub left: Vec<Left>,
    pub healthy: bool,
}

/// What is left of one kind.
#[derive(Serialize)]
pub struct Left {
    kind: &'static str,
    severity: &'static str,
    total: u64,
    #[serde(skip)]
    words: [&'static str; 3],
}

/// Wall time of the phases, in seconds.
#[derive(Default, Serialize)]
struct Seconds {
    read: f64,
    examine: f64,
    repair: f64,
    write: f64,
}

impl Describer {
    /// Lists how much there is of each kind.
    pub fn kinds(&self, found: &Diagnosis) -> Vec<Left> {
        let left = |(kind, listed): &(Kind, delone::Listed<_>)| Left {
            kind: kind.name(),
            severity: name_of(kind.severity()),
            total: listed.count,
            words: meaning::of(*kind),
        };
        found.troubles.iter().map(left).collect()
    }

    fn groups(&self, found: &Diagnosis) -> Vec<Group> {
        let mut marks = self.marks(found).into_iter();
        let group = |(kind, listed): &(Kind, delone::Listed<delone::doctor::Trouble>)| {
            let cases = listed.first.iter().zip(marks.by_ref());
            let cases = cases.map(|(trouble, mark)| Case {
                number: mark.number,
                text: mark.text,
                points: mark.points,
                segments: mark.segments,
                polygon: mark.polygon,
                seeds: self.seeds(trouble),
                at: mark.at.map(Into::into),
                to: mark.to.map(Into::into),
                size: mark.size,
            });
            Group {
                listed: cases.collect(),
                kind: kind.name(),
                severity: name_of(kind.severity()),
                total: listed.count,
                words: meaning::of(*kind),
            }
        };
        found.troubles.iter().map(group).collect()
    }
}

impl Report {
    /// Puts a report together.
    pub fn new(patient: &Patient, found: &Diagnosis, tolerance: f64) -> Self {
        Self {
            file: patient.name.clone(),
            base: patient.base(),
            points: patient.pslg.points.len(),
            segments: patient.pslg.segments.len(),
            tolerance,
            healthy: found.is_healthy(),
            errors: found.count(Severity::Error),
            warnings: found.count(Severity::Warning),
            notes: found.count(Severity::Note),
            suggestion: found.suggestion,
            sharpest: found.sharpest.as_ref().and_then(|corner| corner.size),
            corners_below_60: found.corners_below_60,
            domain_known: found.is_domain_known,
            troubles: Describer::of(patient).groups(found),
            repair: None,
            seconds: Seconds::default(),
            peak_rss_bytes: peak_rss_bytes(),
        }
    }

    /// Adds what has been repaired.
    pub fn with_repair(self, repair: RepairReport) -> Self {
        Self {
            repair: Some(repair),
            ..self
        }
    }

    /// Adds how long reading, examining, repairing and writing took.
    pub fn took(self, took: [Duration; 4]) -> Self {
        let [read, examine, repair, write] = took.map(|t| t.as_secs_f64());
        Self {
            seconds: Seconds {
                read,
                examine,
                repair,
                write,
            },
            ..self
        }
    }

    fn verdict(&self) -> String {
        if self.errors + self.warnings + self.notes == 0 {
            return "healthy, nothing to say".to_owned();
        }
        let words = [
            counted(self.errors as usize, "error", "errors"),
            counted(self.warnings as usize, "warning", "warnings"),
            counted(self.notes as usize, "note", "notes"),
        ]
        .join(", ");
        match self.healthy {
            true => format!("healthy: {words}"),
            false => words,
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}.", self.file, self.verdict())?;
        let tolerance = match self.tolerance {
            0.0 => "exact, no tolerance".to_owned(),
            tolerance => format!("tolerance {tolerance}"),
        };
        let points = counted(self.points, "point", "points");
        let segments = counted(self.segments, "segment", "segments");
        writeln!(f, "  {points} and {segments}; {tolerance}")?;
        for group in &self.troubles {
            write!(f, "{group}")?;
        }
        if let Some(degrees) = self.sharpest.filter(|_| self.corners_below_60 > 0) {
            let corners = counted(self.corners_below_60 as usize, "corner", "corners");
            let sharpest = measure(degrees);
            writeln!(
                f,
                "  {corners} below 60°, the sharpest {sharpest}°: no mesh has larger angles there"
            )?;
        }
        if !self.domain_known {
            writeln!(
                f,
                "  too many crossings to ask what the segments enclose, and where seeds lie"
            )?;
        }
        if let Some(gap) = self.suggestion {
            writeln!(
                f,
                "  --tolerance {gap} would close the gaps that look like mistakes"
            )?;
        }
        if self.base == 1 {
            writeln!(f, "  (Numbers count from 1, as in the file.)")?;
        }
        if let Some(repair) = &self.repair {
            write!(f, "{repair}")?;
        }
        let [read, examine] = [self.seconds.read, self.seconds.examine];
        let [read, examine] = [read, examine].map(|s| duration(Duration::from_secs_f64(s)));
        write!(f, "  read in {read}, examined in {examine}")
    }
}

impl fmt::Display for Group {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [one, many, meaning] = self.words;
        let total = counted(self.total as usize, one, many);
        writeln!(f, "  {}: {total}. {meaning}", self.severity)?;
        for case in &self.listed {
            writeln!(f, "    {}. {}", case.number, case.text)?;
        }
        match self.total as usize - self.listed.len() {
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

impl fmt::Display for RepairReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points = counted(self.points, "point", "points");
        let segments = counted(self.segments, "segment", "segments");
        let rounds = counted(self.rounds, "round", "rounds");
        writeln!(
            f,
            "  Repaired to {}: {points}, {segments}, in {rounds}.",
            self.file
        )?;
        self.write_points(f)?;
        self.write_segments(f)?;
        if self.closed > 0 {
            let lines = counted(self.closed as usize, "line", "lines");
            writeln!(f, "    closed {lines}")?;
        }
        if !self.settled {
            writeln!(
                f,
                "    it would not settle; what is left is clean, but may have near misses"
            )?;
        }
        for left in self.left.iter().filter(|left| left.severity != "note") {
            let [one, many, _] = left.words;
            writeln!(f, "    left: {}", counted(left.total as usize, one, many))?;
        }
        Ok(())
    }
}

impl RepairReport {
    fn write_points(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points = |n| counted(n, "point", "points");
        if self.moved.total > 0 {
            let largest = measure(self.largest);
            writeln!(
                f,
                "    moved {}, by at most {largest}",
                points(self.moved.total)
            )?;
            for (point, _, at, distance) in &self.moved.listed {
                let [x, y] = at;
                writeln!(
                    f,
                    "      point {point} to ({x:?}, {y:?}), by {}",
                    measure(*distance)
                )?;
            }
        }
        if self.merged.total > 0 {
            writeln!(f, "    merged {} with another", points(self.merged.total))?;
        }
        if self.dropped > 0 {
            let dropped = points(self.dropped);
            writeln!(
                f,
                "    attributes or markers of {dropped} lost: others stay there"
            )?;
        }
        Ok(())
    }

    fn write_segments(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let segments = |n| counted(n, "segment", "segments");
        if self.split.total > 0 {
            writeln!(
                f,
                "    led segments through points {} times",
                self.split.total
            )?;
            for (segment, [x, y], distance) in &self.split.listed {
                let far = match distance {
                    0.0 => "on it".to_owned(),
                    distance => format!("{} away", measure(*distance)),
                };
                writeln!(f, "      segment {segment} through ({x:?}, {y:?}), {far}")?;
            }
        }
        if self.cuts.total > 0 {
            writeln!(
                f,
                "    cut segments at {}",
                counted(self.cuts.total, "crossing", "crossings")
            )?;
        }
        if self.vanished.total > 0 {
            writeln!(
                f,
                "    dropped {} of no length",
                segments(self.vanished.total)
            )?;
        }
        if self.doubled.total > 0 {
            writeln!(
                f,
                "    dropped {} that others cover",
                segments(self.doubled.total)
            )?;
        }
        Ok(())
    }
}
