//! The figures of a run, for people and for programs.

use crate::memory::peak_rss_bytes;
use crate::sample;
use crate::words::{count, counted, duration, list};
use delone::Triangulation;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

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
    steiner: usize,
    threads: usize,
    hash: String,
}

/// Wall time of the phases, in seconds.
#[derive(Serialize)]
pub struct Seconds {
    read: f64,
    triangulate: f64,
    write: f64,
}

impl Seconds {
    /// Takes the durations of the phases.
    pub fn new(read: Duration, triangulate: Duration, write: Duration) -> Self {
        let [read, triangulate, write] = [read, triangulate, write].map(|d| d.as_secs_f64());
        Self {
            read,
            triangulate,
            write,
        }
    }
}

impl Figures {
    /// Counts and names the result. *Cost*: about 20 ns a triangle, for the hash.
    pub fn of(result: &Triangulation, threads: usize) -> Self {
        Self {
            vertices: result.num_vertices(),
            triangles: result.num_triangles(),
            edges: result.num_edges(),
            hull_edges: result.num_hull_edges(),
            duplicates: result.duplicates().len(),
            steiner: 0,
            threads,
            hash: result.hash().to_string(),
        }
    }

    fn in_words(&self) -> String {
        let mut text = format!(
            "{}, {}, {} of which {} on the hull",
            counted(self.vertices, "vertex", "vertices"),
            counted(self.triangles, "triangle", "triangles"),
            counted(self.edges, "edge", "edges"),
            count(self.hull_edges),
        );
        if self.duplicates > 0 {
            let merged = counted(self.duplicates, "duplicate", "duplicates");
            text.push_str(&format!("; {merged} merged"));
        }
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
            eprintln!("{}\n", sample::ABOUT);
        }
        eprintln!("{}", self.figures.in_words());
        eprintln!("hash {}", self.figures.hash);
        eprintln!("{}", self.effort());
        if !written.is_empty() {
            let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
            eprintln!("wrote {}", list(&names));
        }
        if is_demonstration {
            eprintln!("\n{}", sample::NEXT);
        }
    }

    fn effort(&self) -> String {
        let [read, triangulate, write] = [
            self.seconds.read,
            self.seconds.triangulate,
            self.seconds.write,
        ]
        .map(|s| duration(Duration::from_secs_f64(s)));
        let threads = counted(self.figures.threads, "thread", "threads");
        format!("read in {read}, triangulated in {triangulate} ({threads}), written in {write}")
    }
}
