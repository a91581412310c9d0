//! What is said about the work, in a few lines.

use crate::words::{count, counted, list, measure};
use delone::{ConstrainedTriangulation, Pslg, Report, check};
use std::fmt;
use std::path::PathBuf;

/// Input, mesh and files in a line each.
pub struct Summary(Vec<String>);

impl Summary {
    /// Begins with what was read.
    pub fn of_input(file: &str, pslg: &Pslg) -> Self {
        Self(vec![format!("{file}: {}", crate::words::domain(pslg))])
    }

    /// Adds what has been made of it.
    pub fn add_mesh(&mut self, mesh: &ConstrainedTriangulation, report: Option<&Report>) {
        let triangulation = mesh.triangulation();
        let (points, triangles) = (triangulation.points(), triangulation.triangles());
        let mut line = format!(
            "{}, {}, {}",
            counted(points.len(), "vertex", "vertices"),
            counted(triangles.len(), "triangle", "triangles"),
            counted(triangulation.num_edges(), "edge", "edges"),
        );
        if let Some(report) = report {
            let [on_segments, free] = [report.on_segments, report.free].map(count);
            line += &format!("; added: {on_segments} on segments, {free} elsewhere");
        }
        if !triangles.is_empty() {
            let smallest = check::statistics(points, triangles).min_angle;
            line += &format!("; smallest angle {} degrees", measure(smallest));
        }
        self.0.push(line);
        if let Some(report) = report.filter(|report| !report.unmet.is_empty()) {
            let unmet = counted(report.unmet.len(), "triangle is", "triangles are");
            let excused = count(report.unmet.len() - report.num_unexcused());
            self.0.push(format!(
                "{unmet} not as asked, {excused} of them because the input forbids it"
            ));
        }
    }

    /// Adds the names of the files.
    pub fn add_files(&mut self, written: &[PathBuf]) {
        let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
        if !names.is_empty() {
            self.0.push(format!("wrote {}", list(&names)));
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join("\n"))
    }
}
