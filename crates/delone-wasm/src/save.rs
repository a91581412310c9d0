//! Files to be downloaded: every format that the library writes, as bytes. The name's extension tells the format.

use crate::drawing::Drawing;
use crate::mesh::{Built, Mesh};
use crate::play::Player;
use crate::{Trouble, json};
use delone::voronoi::{Domain, Voronoi};
use delone::{Point, Triangulation};
use delone_io::{
    AnimationOptions, CellsView, Error, Inherited, LogFormat, MemoryFile, MeshView, Pace,
    PictureOptions, ReportOptions, ShownSteps, Strip, Target, WriteOptions, in_memory,
    write_animation, write_cells, write_domain, write_log, write_mesh, write_report,
};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use wasm_bindgen::prelude::wasm_bindgen;

/// Share of the larger side of the box around points that is added on each side, for their cells.
const MARGIN: f64 = 0.1;

/// A file: its name and its bytes.
#[wasm_bindgen]
pub struct SavedFile {
    file: MemoryFile,
}

#[wasm_bindgen]
impl SavedFile {
    /// Returns its name.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.file.name.display().to_string()
    }

    /// Returns its content.
    pub fn bytes(&self) -> Vec<u8> {
        self.file.bytes.clone()
    }
}

/// How files look.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub(crate) struct Options {
    one_based: bool,
    quadratic: bool,
    size: Option<u32>,
    legend: Option<bool>,
}

impl Options {
    fn writing(&self) -> WriteOptions {
        let usual = PictureOptions::default();
        WriteOptions {
            one_based: self.one_based,
            picture: PictureOptions {
                size: self.size.unwrap_or(usual.size),
                legend: self.legend.unwrap_or(usual.legend),
            },
            ..WriteOptions::default()
        }
    }
}

/// How a run is shown.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
struct Showing {
    size: Option<u32>,
    seconds: Option<f64>,
    per_second: Option<f64>,
    max_frames: Option<usize>,
    frames: Option<usize>,
    changes_only: bool,
}

impl Showing {
    fn animation(&self) -> AnimationOptions {
        let usual = AnimationOptions::default();
        AnimationOptions {
            size: self.size.unwrap_or(usual.size),
            pace: match (self.seconds, self.per_second) {
                (Some(seconds), _) => Pace::InSeconds(seconds),
                (None, Some(rate)) => Pace::PerSecond(rate),
                (None, None) => usual.pace,
            },
            shown: match self.changes_only {
                true => ShownSteps::Changes,
                false => ShownSteps::All,
            },
            max_frames: self.max_frames.unwrap_or(usual.max_frames),
            strip: Strip {
                frames: self.frames.unwrap_or(usual.strip.frames),
                ..usual.strip
            },
            ..usual
        }
    }
}

#[wasm_bindgen]
impl Drawing {
    /// Writes the drawing: points and segments to `.poly`, `.geojson`, `.svg` or `.png`, bare points also to
    /// `.csv`, `.node`, `.npy`, `.vtu` and others. `options` is JSON: `{oneBased, size, legend}`.
    pub fn save(&self, name: &str, options: Option<String>) -> Result<Vec<SavedFile>, Trouble> {
        let options: Options = json::options(options.as_deref())?;
        kept(|| write_domain(&target(name), &self.data, &options.writing(), &()))
    }
}

#[wasm_bindgen]
impl Player {
    /// Writes the run: `.svg` and `.gif` move, `.png` is a filmstrip, `.json` and `.dlog` are logs, which
    /// `fromLog` reads again. `options` is JSON: `{size, seconds, perSecond, maxFrames, frames, changesOnly}`;
    /// `frames` are those of a filmstrip.
    pub fn save(&self, name: &str, options: Option<String>) -> Result<Vec<SavedFile>, Trouble> {
        let showing: Showing = json::options(options.as_deref())?;
        let recording = self.recording();
        if LogFormat::from_path(Path::new(name)).is_some() {
            return kept(|| write_log(recording, Some(Path::new(name)), None, &()));
        }
        kept(|| {
            let report = write_animation(&target(name), recording, &showing.animation(), &())?;
            Ok(report.files)
        })
    }
}

/// Writes a mesh.
pub(crate) fn mesh(mesh: &Mesh, name: &str, options: Options) -> Result<Vec<SavedFile>, Trouble> {
    let write = |view: MeshView<'_>| {
        let view = match options.quadratic {
            true => view.quadratic(),
            false => view,
        };
        write_mesh(&target(name), &view, &options.writing(), &())
    };
    kept(|| match &mesh.built {
        Built::Points(t) => write(MeshView::from(t).with_data(&mesh.data.vertices)),
        Built::Domain(domain) => {
            let inherited = Inherited::new(domain, mesh.data.clone(), &())?;
            write(MeshView::constrained(domain, &inherited))
        }
        Built::Refined(refined) => {
            let inherited = Inherited::new(&refined.mesh, mesh.data.clone(), &())?;
            write(MeshView::constrained(&refined.mesh, &inherited))
        }
    })
}

/// Writes the report of a refined mesh.
pub(crate) fn report(mesh: &Mesh, name: &str, headline: &str) -> Result<Vec<SavedFile>, Trouble> {
    let Some(refined) = mesh.refined() else {
        let message = "there is a report of refined meshes only";
        return Err(Trouble::asked(message));
    };
    let details = [("hash of the triangles", mesh.hash())];
    let options = ReportOptions {
        name: headline,
        details: &details,
        ..ReportOptions::default()
    };
    kept(|| {
        let inherited = Inherited::new(&refined.mesh, mesh.data.clone(), &())?;
        let view = MeshView::constrained(&refined.mesh, &inherited);
        write_report(&target(name), refined, &view, &options, &())
    })
}

/// Writes the Voronoi cells of the points of a mesh.
pub(crate) fn cells(mesh: &Mesh, name: &str, options: Options) -> Result<Vec<SavedFile>, Trouble> {
    let t = delaunay(mesh)?;
    let voronoi = Voronoi::new(&t, &())?;
    let [low, high] = around(t.points());
    let clipped = voronoi.clip(&Domain::rectangle(low, high)?, &())?;
    let view = CellsView::new(&clipped);
    kept(|| write_cells(&target(name), &view, &options.writing(), &()))
}

/// Triangulates the vertices of a mesh without its domain.
fn delaunay(mesh: &Mesh) -> Result<Triangulation, Trouble> {
    Ok(delone::triangulate(mesh.triangulation().points().to_vec())?)
}

/// Returns a box with room around points.
pub(crate) fn around(points: &[Point]) -> [Point; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        low = [low[0].min(p.x), low[1].min(p.y)];
        high = [high[0].max(p.x), high[1].max(p.y)];
    }
    let side = (high[0] - low[0]).max(high[1] - low[1]);
    let margin = match side.is_finite() && side > 0.0 {
        true => MARGIN * side,
        false => 1.0,
    };
    if points.is_empty() {
        (low, high) = ([0.0; 2], [0.0; 2]);
    }
    [low.map(|c| c - margin), high.map(|c| c + margin)].map(Point::from)
}

fn target(name: &str) -> [Target; 1] {
    [Target::from_arg(name, None)]
}

/// Takes what is written.
fn kept(write: impl FnOnce() -> Result<Vec<PathBuf>, Error>) -> Result<Vec<SavedFile>, Trouble> {
    let (_, files) = in_memory(write)?;
    Ok(files.into_iter().map(|file| SavedFile { file }).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(files: &[SavedFile]) -> Vec<String> {
        files.iter().map(SavedFile::name).collect()
    }

    fn refined() -> Mesh {
        let drawing = Drawing::preset("thesis", 0, 0).expect("a preset");
        let options = r#"{"minAngle": 20, "maxEdge": 1}"#.to_owned();
        Mesh::refine(&drawing, Some(options), None).expect("a mesh")
    }

    #[test]
    fn meshes_go_into_every_format() {
        let mesh = refined();
        let family = mesh.save("m.ele", None).expect("files");
        let all = ["m.node", "m.ele", "m.edge", "m.neigh", "m.poly"];
        assert!(
            all.iter()
                .all(|name| names(&family).contains(&(*name).to_owned()))
        );
        for name in ["m.vtu", "m.geojson", "m.svg", "m.png", "m.npy"] {
            let files = mesh.save(name, None).expect(name);
            assert!(files.iter().all(|f| !f.bytes().is_empty()), "{name}");
        }
        mesh.save("m.gif", None).err().expect("no mesh moves");
        mesh.save("m", None).err().expect("no format");
    }

    #[test]
    fn reports_are_about_refined_meshes() {
        let page = refined().save_report("r.html", "thesis").expect("a page");
        assert!(page[0].bytes().starts_with(b"<!"));
        let drawing = Drawing::preset("uniform", 20, 0).expect("a preset");
        let bare = Mesh::triangulate(&drawing, None).expect("a mesh");
        bare.save_report("r.html", "bare")
            .err()
            .expect("not refined");
    }

    #[test]
    fn cells_and_drawings_are_written() {
        for preset in ["uniform", "collinear", "cocircular", "gallery"] {
            let drawing = Drawing::preset(preset, 20, 0).expect("a preset");
            let mesh = Mesh::triangulate(&drawing, None).expect("a mesh");
            let cells = mesh.save_cells("c.geojson", None).expect("cells");
            assert!(!cells[0].bytes().is_empty(), "{preset}");
            assert_eq!(
                names(&drawing.save("d.csv", None).expect("points")),
                ["d.csv"]
            );
        }
        let lake = Drawing::preset("lake", 0, 0).expect("a preset");
        assert_eq!(
            names(&lake.save("lake.poly", None).expect("a domain")),
            ["lake.poly"]
        );
    }

    #[test]
    fn no_points_at_all_are_no_panic() {
        let nothing = Drawing::new(&[], &[], &[]).expect("a drawing");
        let mesh = Mesh::triangulate(&nothing, None).expect("a mesh");
        mesh.save_cells("c.svg", None).map(drop).unwrap_or(());
        mesh.save("m.svg", None).map(drop).unwrap_or(());
    }
}
