//! What `delone info` has found, for people and for programs.

use super::trouble::{
    Crossing, Duplicate, End, Listed, OnSegment, Overlap, Place, Repeated, Ring, ZeroLength,
};
use crate::domain::Rule;
use crate::memory::peak_rss_bytes;
use crate::words::{self, counted, duration};
use delone::{Facts, Point, Pslg, VertexId};
use delone_io::DomainData;
use serde::Serialize;
use std::fmt;
use std::time::Duration;

/// Counts and troubles; the fields are the keys of `--json`, in this order.
#[derive(Serialize)]
pub struct Report {
    file: String,
    base: usize,
    points: usize,
    segments: usize,
    polygons: usize,
    holes: usize,
    regions: usize,
    bounds: Option<[Place; 2]>,
    usual_rule: String,
    clean: bool,
    collinear: bool,
    duplicates: Listed<Duplicate>,
    loose_points: Listed<End>,
    open_ends: Listed<End>,
    zero_length: Listed<ZeroLength>,
    repeated: Listed<Repeated>,
    on_segments: Listed<OnSegment>,
    overlaps: Listed<Overlap>,
    crossings: Listed<Crossing>,
    rings: Rings,
    seconds: Seconds,
    peak_rss_bytes: Option<u64>,
    /// What the file holds, in words.
    #[serde(skip)]
    content: String,
}

/// The rings: how many, the first of them, and whether they do not meet, so that their nesting is
/// known.
#[derive(Serialize)]
struct Rings {
    #[serde(flatten)]
    all: Listed<Ring>,
    apart: bool,
}

/// Wall time of the phases, in seconds.
#[derive(Serialize)]
struct Seconds {
    read: f64,
    examine: f64,
}

/// Translates facts into the numbers of the file.
struct Translator<'a> {
    pslg: &'a Pslg,
    base: usize,
}

impl Translator<'_> {
    fn place(&self, v: VertexId) -> Place {
        self.pslg.points[v.index()].into()
    }

    fn point(&self, v: VertexId) -> usize {
        v.index() + self.base
    }

    fn end(&self, v: VertexId) -> End {
        End {
            point: self.point(v),
            at: self.place(v),
        }
    }

    fn duplicate(&self, [point, equals]: [VertexId; 2]) -> Duplicate {
        Duplicate {
            point: self.point(point),
            equals: self.point(equals),
            at: self.place(point),
        }
    }

    fn zero_length(&self, segment: usize) -> ZeroLength {
        ZeroLength {
            segment: segment + self.base,
            at: self.place(self.pslg.segments[segment][0]),
        }
    }

    fn repeated(&self, [segment, equals]: [usize; 2]) -> Repeated {
        Repeated {
            segment: segment + self.base,
            equals: equals + self.base,
            ends: self.pslg.segments[segment].map(|v| self.place(v)),
        }
    }

    /// Of the four ends on one line, the middle ones are those of the common part.
    fn overlap(&self, segments: [usize; 2]) -> Overlap {
        let ends = segments.map(|s| self.pslg.segments[s]);
        let mut ends: Vec<Point> = ends
            .as_flattened()
            .iter()
            .map(|v| self.pslg.points[v.index()])
            .collect();
        ends.sort_by(Point::lex_cmp);
        Overlap {
            segments: segments.map(|s| s + self.base),
            ends: [ends[1].into(), ends[2].into()],
        }
    }

    fn rings(&self, facts: &Facts, limit: usize) -> Rings {
        let name = |i: usize| facts.rings[i].segment + self.base;
        let ring = |ring: &delone::Ring| Ring {
            segment: ring.segment + self.base,
            segments: ring.len,
            depth: ring.depth,
            inside: ring.parent.map(name),
        };
        Rings {
            all: Listed {
                total: facts.rings.len() as u64,
                listed: facts.rings.iter().take(limit).map(ring).collect(),
            },
            apart: facts.are_rings_apart,
        }
    }
}

impl Report {
    /// Puts a report together; `domain` is what `pslg` has been taken from.
    pub fn new(
        file: String,
        domain: &DomainData,
        pslg: &Pslg,
        facts: &Facts,
        limit: usize,
    ) -> Self {
        let base = domain.vertices.base as usize;
        let its = Translator { pslg, base };
        Self {
            file,
            base,
            points: facts.points,
            segments: facts.segments,
            polygons: pslg.polygons.len(),
            holes: pslg.holes.len(),
            regions: pslg.regions.len(),
            bounds: bounds(&pslg.points),
            usual_rule: Rule::from(domain.usual_rule).to_string(),
            clean: facts.is_clean(),
            collinear: facts.is_collinear,
            duplicates: Listed::of(&facts.duplicates, |d| its.duplicate(d)),
            loose_points: Listed::of(&facts.loose_points, |v| its.end(v)),
            open_ends: Listed::of(&facts.open_ends, |v| its.end(v)),
            zero_length: Listed::of(&facts.zero_length, |s| its.zero_length(s)),
            repeated: Listed::of(&facts.repeated, |s| its.repeated(s)),
            on_segments: Listed::of(&facts.on_segments, |on| OnSegment {
                point: its.point(on.vertex),
                segment: on.segment + base,
                at: on.at.into(),
            }),
            overlaps: Listed::of(&facts.overlaps, |s| its.overlap(s)),
            crossings: Listed::of(&facts.crossings, |crossing| Crossing {
                segments: crossing.segments.map(|s| s + base),
                at: crossing.at.into(),
            }),
            rings: its.rings(facts, limit),
            seconds: Seconds {
                read: 0.0,
                examine: 0.0,
            },
            peak_rss_bytes: peak_rss_bytes(),
            content: words::domain(pslg),
        }
    }

    /// Adds how long reading and examining took.
    pub fn took(mut self, [read, examine]: [Duration; 2]) -> Self {
        self.seconds = Seconds {
            read: read.as_secs_f64(),
            examine: examine.as_secs_f64(),
        };
        self
    }

    /// Writes the JSON object, on one line.
    pub fn json(&self) -> String {
        serde_json::to_string(self).expect("bug: numbers and strings always serialise")
    }

    fn verdict(&self) -> &'static str {
        match (self.clean, self.segments) {
            (true, 0) => "no segments",
            (true, _) => "clean, segments meet at common ends only",
            (false, _) => "segments meet elsewhere than at common ends",
        }
    }

    fn write_head(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}.", self.file, self.verdict())?;
        writeln!(f, "  {} (rule: {})", self.content, self.usual_rule)?;
        if let Some([low, high]) = self.bounds {
            let on_a_line = if self.collinear {
                ", all on one line"
            } else {
                ""
            };
            writeln!(f, "  from {low} to {high}{on_a_line}")?;
        }
        Ok(())
    }

    fn write_rings(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.rings.all.write(f, "closed ring", "closed rings")?;
        if self.rings.apart {
            return Ok(());
        }
        writeln!(f, "    (they meet, so none is inside another)")
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_head(f)?;
        let loose = counted(
            self.loose_points.total as usize,
            "loose point",
            "loose points",
        );
        if self.segments > 0 && self.loose_points.total > 0 {
            writeln!(f, "  {loose}")?;
        }
        self.write_rings(f)?;
        self.open_ends.write(f, "open end", "open ends")?;
        self.duplicates
            .write(f, "duplicate point", "duplicate points")?;
        let many = "segments of no length";
        self.zero_length.write(f, "segment of no length", many)?;
        self.repeated
            .write(f, "repeated segment", "repeated segments")?;
        let many = "points inside segments";
        self.on_segments.write(f, "point inside a segment", many)?;
        let many = "pairs of segments that overlap";
        self.overlaps
            .write(f, "pair of segments that overlap", many)?;
        let many = "pairs of segments that cross";
        self.crossings
            .write(f, "pair of segments that cross", many)?;
        if self.base == 1 {
            writeln!(f, "  (Numbers count from 1, as in the file.)")?;
        }
        let [read, examine] = [self.seconds.read, self.seconds.examine];
        let [read, examine] = [read, examine].map(|s| duration(Duration::from_secs_f64(s)));
        write!(f, "  read in {read}, examined in {examine}")
    }
}

/// Returns the corners of the bounding box.
fn bounds(points: &[Point]) -> Option<[Place; 2]> {
    let (first, rest) = points.split_first()?;
    let corners = rest.iter().fold([*first; 2], |[low, high], p| {
        [
            Point::new(low.x.min(p.x), low.y.min(p.y)),
            Point::new(high.x.max(p.x), high.y.max(p.y)),
        ]
    });
    Some(corners.map(Place::from))
}
