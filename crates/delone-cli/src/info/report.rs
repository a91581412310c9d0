//! What `delone info` has found, for people and for programs.

use super::columns::{Column, Markers};
use crate::domain::Rule;
use crate::memory::peak_rss_bytes;
use crate::words::{self, counted, duration};
use delone::{Facts, Point, Pslg, Region};
use delone_io::{DomainData, MeshData};
use serde::Serialize;
use std::fmt;
use std::time::Duration;

/// What a file holds; the fields are the keys of `--json`, in this order.
#[derive(Serialize)]
pub struct Report {
    file: String,
    base: usize,
    points: usize,
    segments: usize,
    polygons: usize,
    holes: usize,
    triangles: usize,
    bounds: Option<[[f64; 2]; 2]>,
    collinear: bool,
    usual_rule: String,
    columns: Vec<Column>,
    triangle_columns: Vec<Column>,
    point_markers: Option<Markers>,
    segment_markers: Option<Markers>,
    regions: Regions,
    rings: Rings,
    seconds: Seconds,
    peak_rss_bytes: Option<u64>,
    /// What the file holds, in words.
    #[serde(skip)]
    content: String,
}

/// The regions: how many, and the first of them.
#[derive(Serialize)]
struct Regions {
    total: usize,
    listed: Vec<Seed>,
}

/// A region, as its seed has it.
#[derive(Serialize)]
struct Seed {
    at: [f64; 2],
    attribute: f64,
    max_area: Option<f64>,
}

/// The rings: how many, the first of them, and whether they do not meet, so that their nesting is
/// known.
#[derive(Serialize)]
struct Rings {
    total: usize,
    listed: Vec<Ring>,
    apart: bool,
}

/// A ring of segments.
#[derive(Serialize)]
struct Ring {
    /// Its first segment, which names it.
    segment: usize,
    segments: usize,
    /// How many rings are around it.
    depth: usize,
    /// The first segment of the ring directly around it.
    inside: Option<usize>,
}

/// Wall time of the phases, in seconds.
#[derive(Default, Serialize)]
struct Seconds {
    read: f64,
    examine: f64,
}

impl Rings {
    fn of(facts: &Facts, base: usize, limit: usize) -> Self {
        let name = |i: usize| facts.rings[i].segment + base;
        let ring = |ring: &delone::Ring| Ring {
            segment: ring.segment + base,
            segments: ring.len,
            depth: ring.depth,
            inside: ring.parent.map(name),
        };
        Self {
            total: facts.rings.len(),
            listed: facts.rings.iter().take(limit).map(ring).collect(),
            apart: facts.are_rings_apart,
        }
    }
}

impl Regions {
    fn of(regions: &[Region], limit: usize) -> Self {
        let seed = |region: &Region| Seed {
            at: region.at.into(),
            attribute: region.attribute,
            max_area: region.max_area,
        };
        Self {
            total: regions.len(),
            listed: regions.iter().take(limit).map(seed).collect(),
        }
    }
}

impl Report {
    /// Puts a report together; `domain` is what `pslg` has been taken from.
    pub fn new(
        file: String,
        domain: &DomainData,
        mesh: Option<&MeshData>,
        pslg: &Pslg,
        facts: &Facts,
        limit: usize,
    ) -> Self {
        let base = domain.vertices.base as usize;
        let columns = |all: &[delone_io::Attribute]| all.iter().map(Column::from).collect();
        let markers = |all: &Option<Vec<i32>>| all.as_ref().map(|m| Markers::of(m, limit));
        let triangles = mesh.map_or(0, |mesh| mesh.triangles.len());
        let mut content = words::domain(pslg);
        if mesh.is_some() {
            content = format!("{}, {content}", counted(triangles, "triangle", "triangles"));
        }
        Self {
            file,
            base,
            points: facts.points,
            segments: facts.segments,
            polygons: pslg.polygons.len(),
            holes: pslg.holes.len(),
            triangles,
            bounds: bounds(&pslg.points),
            collinear: facts.is_collinear,
            usual_rule: Rule::from(domain.usual_rule).to_string(),
            columns: columns(&domain.vertices.attributes),
            triangle_columns: mesh.map_or_else(Vec::new, |m| columns(&m.triangle_attributes)),
            point_markers: markers(&domain.vertices.markers),
            segment_markers: markers(&domain.segment_markers),
            regions: Regions::of(&pslg.regions, limit),
            rings: Rings::of(facts, base, limit),
            seconds: Seconds::default(),
            peak_rss_bytes: peak_rss_bytes(),
            content,
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

    fn write_head(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}.", self.file, self.content)?;
        if self.triangles == 0 {
            writeln!(f, "  rule: {}", self.usual_rule)?;
        }
        if let Some([low, high]) = self.bounds {
            let on_a_line = if self.collinear {
                ", all on one line"
            } else {
                ""
            };
            writeln!(f, "  from {} to {}{on_a_line}", place(low), place(high))?;
        }
        Ok(())
    }

    fn write_columns(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (what, columns) in [
            ("column", &self.columns),
            ("of triangles,", &self.triangle_columns),
        ] {
            for column in columns {
                writeln!(f, "  {what} {column}")?;
            }
        }
        for (what, markers) in [
            ("points", &self.point_markers),
            ("segments", &self.segment_markers),
        ] {
            if let Some(markers) = markers {
                writeln!(f, "  markers of {what}: {markers}")?;
            }
        }
        Ok(())
    }

    fn write_regions(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, region) in self.regions.listed.iter().enumerate() {
            let area = region
                .max_area
                .map(|area| format!(", triangles up to {area}"));
            let (number, at) = (i + self.base, place(region.at));
            let area = area.unwrap_or_default();
            writeln!(
                f,
                "  region {number} around {at}: attribute {}{area}",
                region.attribute
            )?;
        }
        write_more(
            f,
            "  ",
            self.regions.total - self.regions.listed.len(),
            "region",
            "regions",
        )
    }

    fn write_rings(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.rings.total == 0 {
            return Ok(());
        }
        writeln!(
            f,
            "  {}:",
            counted(self.rings.total, "closed ring", "closed rings")
        )?;
        for ring in &self.rings.listed {
            let segments = counted(ring.segments, "segment", "segments");
            write!(f, "    ring of segment {}: {segments}", ring.segment)?;
            match ring.inside {
                Some(around) => writeln!(f, ", inside the ring of segment {around}")?,
                None => writeln!(f)?,
            }
        }
        write_more(
            f,
            "    ",
            self.rings.total - self.rings.listed.len(),
            "other",
            "others",
        )?;
        if self.rings.apart {
            return Ok(());
        }
        writeln!(f, "    (they meet, so none is inside another)")
    }
}

/// Says how many more there are than listed.
fn write_more(
    f: &mut fmt::Formatter<'_>,
    indent: &str,
    more: usize,
    one: &str,
    many: &str,
) -> fmt::Result {
    match more {
        0 => Ok(()),
        more => writeln!(f, "{indent}and {} (see --limit)", counted(more, one, many)),
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_head(f)?;
        self.write_columns(f)?;
        self.write_regions(f)?;
        self.write_rings(f)?;
        if self.base == 1 {
            writeln!(f, "  (Numbers count from 1, as in the file.)")?;
        }
        let [read, examine] = [self.seconds.read, self.seconds.examine];
        let [read, examine] = [read, examine].map(|s| duration(Duration::from_secs_f64(s)));
        write!(f, "  read in {read}, examined in {examine}")
    }
}

/// A place, written so that it reads back as the same.
fn place([x, y]: [f64; 2]) -> String {
    format!("({x:?}, {y:?})")
}

/// Returns the corners of the bounding box.
fn bounds(points: &[Point]) -> Option<[[f64; 2]; 2]> {
    let (first, rest) = points.split_first()?;
    let corners = rest.iter().fold([*first; 2], |[low, high], p| {
        [
            Point::new(low.x.min(p.x), low.y.min(p.y)),
            Point::new(high.x.max(p.x), high.y.max(p.y)),
        ]
    });
    Some(corners.map(Into::into))
}
