//! The figures of a run, for people and for programs.

use super::build::{Built, Laps};
use crate::memory::peak_rss_bytes;
use crate::voice;
use crate::words::{count, counted, duration, wrote};
use delone::{ConstrainedTriangulation, Triangulation};
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

/// What people are told who try the program.
const ABOUT: &str = "\
lake: shores of islands, a pond on one of them, a river, deep water and shallow, soundings;
drawn by this program (`delone sample lake -o FILE.poly` writes it down)";

/// Counts, name, what the command adds, time and memory; the fields are the keys of `--json`, in this
/// order.
#[derive(Serialize)]
pub struct Report<T> {
    #[serde(flatten)]
    figures: Figures,
    #[serde(flatten)]
    more: T,
    seconds: Seconds,
    peak_rss_bytes: Option<u64>,
    /// The times for people.
    #[serde(skip)]
    times: String,
}

/// Counts and name of a result.
#[derive(Serialize)]
pub struct Figures {
    vertices: usize,
    triangles: usize,
    edges: usize,
    hull_edges: usize,
    duplicates: usize,
    carved: usize,
    segments: usize,
    constrained_edges: usize,
    crossings_split: usize,
    steiner: usize,
    threads: usize,
    hash: String,
}

/// Wall time of the phases, in seconds.
#[derive(Serialize)]
struct Seconds {
    read: f64,
    triangulate: f64,
    constrain: f64,
    carve: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    refine: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    smooth: Option<f64>,
    write: f64,
}

impl Seconds {
    fn new([read, write]: [Duration; 2], laps: &Laps) -> Self {
        Self {
            read: read.as_secs_f64(),
            triangulate: laps.triangulate.as_secs_f64(),
            constrain: laps.constrain.as_secs_f64(),
            carve: laps.carve.as_secs_f64(),
            refine: laps.refine.map(|[refine, _]| refine.as_secs_f64()),
            smooth: laps.refine.map(|[_, smooth]| smooth.as_secs_f64()),
            write: write.as_secs_f64(),
        }
    }
}

impl Figures {
    /// Counts and names what was built. *Cost*: about 20 ns a triangle, for the hash.
    pub fn of(built: &Built, threads: usize) -> Self {
        match built {
            Built::Points(triangulation) => Self::of_points(triangulation, threads),
            Built::Domain(domain) => Self::of_domain(domain, threads),
        }
    }

    /// Counts and names a domain's triangles. *Cost*: about 20 ns a triangle, for the hash.
    pub fn of_domain(domain: &ConstrainedTriangulation, threads: usize) -> Self {
        Self {
            segments: domain.num_input_segments(),
            constrained_edges: domain.constrained_edges().count(),
            crossings_split: domain.num_crossings(),
            steiner: domain.num_steiner(),
            ..Self::of_points(domain.triangulation(), threads)
        }
    }

    /// Returns the number of threads.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Returns the name of the set of triangles.
    pub fn hash(&self) -> &str {
        &self.hash
    }

    fn of_points(result: &Triangulation, threads: usize) -> Self {
        let vertices = num_used(result);
        Self {
            vertices,
            triangles: result.num_triangles(),
            edges: result.num_edges(),
            hull_edges: result.num_boundary_edges(),
            duplicates: result.duplicates().len(),
            carved: result.num_vertices() - vertices,
            segments: 0,
            constrained_edges: 0,
            crossings_split: 0,
            steiner: 0,
            threads,
            hash: result.hash().to_string(),
        }
    }

    fn in_words(&self) -> String {
        let mut text = format!(
            "{}, {}, {} of which {} on the {}",
            counted(self.vertices, "vertex", "vertices"),
            counted(self.triangles, "triangle", "triangles"),
            counted(self.edges, "edge", "edges"),
            count(self.hull_edges),
            if self.segments > 0 { "border" } else { "hull" },
        );
        let mut add = |n: usize, one, many, done: &str| {
            if n > 0 {
                text.push_str(&format!("; {} {done}", counted(n, one, many)));
            }
        };
        add(self.duplicates, "duplicate", "duplicates", "merged");
        add(self.segments, "segment", "segments", "inserted");
        add(self.crossings_split, "crossing", "crossings", "split");
        add(self.carved, "point", "points", "carved away");
        if self.triangles == 0 && self.vertices > 2 {
            text.push_str("; all points lie on one line");
        }
        text
    }
}

impl<T: Serialize> Report<T> {
    /// Adds what the command has to say, how long reading, writing and what lies between them took, and
    /// the memory used so far.
    pub fn new(figures: Figures, more: T, files: [Duration; 2], laps: &Laps) -> Self {
        let [read, write] = files.map(duration);
        let between = laps.in_words(figures.threads);
        Self {
            figures,
            more,
            seconds: Seconds::new(files, laps),
            peak_rss_bytes: peak_rss_bytes(),
            times: format!("read in {read}, {between}, written in {write}"),
        }
    }

    /// Writes the JSON object, on one line.
    pub fn json(&self) -> String {
        serde_json::to_string(self).expect("bug: numbers and strings always serialise")
    }

    /// Tells people on standard error; `more` are lines of the command's own, and whoever tries the
    /// program is told what comes `next`.
    pub fn summarise(&self, more: &[String], next: Option<&str>, written: &[PathBuf]) {
        if next.is_some() {
            voice::say(&format!("{ABOUT}\n"));
        }
        voice::say(&self.figures.in_words());
        for line in more {
            voice::say(line);
        }
        voice::say(&format!("hash {}", self.figures.hash));
        voice::say(&self.times);
        if let Some(files) = wrote(written) {
            voice::say(&files);
        }
        if let Some(next) = next {
            voice::say(&format!("\n{next}"));
        }
    }
}

/// Counts the vertices of the triangles; if no three points make one, all vertices.
fn num_used(result: &Triangulation) -> usize {
    let faces = result.mesh().faces();
    if faces
        .first()
        .is_none_or(|face| face.iter().any(|v| v.is_infinite()))
    {
        return result.num_vertices();
    }
    let mut used = vec![false; result.points().len()];
    for v in result.triangles().as_flattened() {
        used[v.index()] = true;
    }
    used.into_iter().filter(|&used| used).count()
}
