//! The figures of a run, for people and for programs.

use super::build::{Built, Laps};
use crate::memory::peak_rss_bytes;
use crate::words::{count, counted, duration, list};
use delone::Triangulation;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

/// What people are told who try the program.
const ABOUT: &str = "\
lake: shores of islands, a pond on one of them, a river, deep water and shallow, soundings;
drawn by this program (`delone sample lake -o FILE.poly` writes it down)";

/// What to do after the first try.
const NEXT: &str = "\
Next: open lake.png, or let the result be verified from its files alone:
  delone sample lake -o drawing.poly
  delone check lake.ele --domain drawing.poly
Your own: delone triangulate map.poly -o mesh.ele --picture mesh.png (`delone info map.poly` first)";

/// Counts, name, time and memory; the fields are the keys of `--json`, in this order.
#[derive(Serialize)]
pub struct Report {
    #[serde(flatten)]
    figures: Figures,
    seconds: Seconds,
    peak_rss_bytes: Option<u64>,
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
pub struct Seconds {
    read: f64,
    triangulate: f64,
    constrain: f64,
    carve: f64,
    write: f64,
}

impl Seconds {
    /// Takes the durations of the phases.
    pub fn new(read: Duration, laps: Laps, write: Duration) -> Self {
        Self {
            read: read.as_secs_f64(),
            triangulate: laps.triangulate.as_secs_f64(),
            constrain: laps.constrain.as_secs_f64(),
            carve: laps.carve.as_secs_f64(),
            write: write.as_secs_f64(),
        }
    }
}

impl Figures {
    /// Counts and names the result. *Cost*: about 20 ns a triangle, for the hash.
    pub fn of(built: &Built, threads: usize) -> Self {
        let result = built.triangulation();
        let vertices = num_used(result);
        let figures = Self {
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
        };
        let Built::Domain(domain) = built else {
            return figures;
        };
        Self {
            segments: domain.segments().len(),
            constrained_edges: domain.constrained_edges().count(),
            crossings_split: domain.num_crossings(),
            ..figures
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

impl Report {
    /// Adds time, and the memory used so far.
    pub fn new(figures: Figures, seconds: Seconds) -> Self {
        Self {
            figures,
            seconds,
            peak_rss_bytes: peak_rss_bytes(),
        }
    }

    /// Writes the JSON object, on one line.
    pub fn json(&self) -> String {
        serde_json::to_string(self).expect("bug: numbers and strings always serialise")
    }

    /// Tells people on standard error.
    pub fn summarise(&self, is_demonstration: bool, written: &[PathBuf]) {
        if is_demonstration {
            eprintln!("{}\n", ABOUT);
        }
        eprintln!("{}", self.figures.in_words());
        eprintln!("hash {}", self.figures.hash);
        eprintln!("{}", self.effort());
        if !written.is_empty() {
            let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
            eprintln!("wrote {}", list(&names));
        }
        if is_demonstration {
            eprintln!("\n{}", NEXT);
        }
    }

    fn effort(&self) -> String {
        let seconds = &self.seconds;
        let took = |s: f64| duration(Duration::from_secs_f64(s));
        let build = seconds.triangulate + seconds.constrain + seconds.carve;
        let [read, build, write] = [seconds.read, build, seconds.write].map(took);
        let threads = counted(self.figures.threads, "thread", "threads");
        format!("read in {read}, triangulated in {build} ({threads}), written in {write}")
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
