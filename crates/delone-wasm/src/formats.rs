//! Which files there are, for the menus of a page: as the code that reads and writes them has it.

use crate::json;
use delone_io::{Format, LogFormat};
use serde::Serialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// A kind of files.
#[derive(Serialize)]
struct Row {
    extension: &'static str,
    extensions: Vec<&'static str>,
    what: &'static str,
    reads: bool,
    drawing: bool,
    points: bool,
    mesh: bool,
    quadratic: bool,
    cells: bool,
    report: bool,
    run: bool,
}

impl Row {
    fn of(format: Format) -> Self {
        Self {
            extension: format.name(),
            extensions: format.extensions().to_vec(),
            what: format.about(),
            reads: format.reads_points(),
            drawing: format.writes_segments(),
            points: format.writes_segments() || format.writes_points(),
            mesh: format.writes_mesh(),
            quadratic: format.writes_quadratic_mesh(),
            cells: format.writes_cells(),
            report: format.writes_report(),
            run: format.writes_animation(),
        }
    }

    /// Of logs, which hold runs and nothing else.
    fn of_log(format: LogFormat) -> Self {
        let what = match format {
            LogFormat::Json => "log of a run, as text",
            LogFormat::Binary => "log of a run, in a tenth of the room",
        };
        Self {
            extension: format.name(),
            extensions: vec![format.name()],
            what,
            reads: true,
            drawing: false,
            points: false,
            mesh: false,
            quadratic: false,
            cells: false,
            report: false,
            run: true,
        }
    }
}

/// Lists the formats of files, as JSON: `[{extension, extensions, what, reads, drawing, points, mesh, quadratic,
/// cells, report, run}]`. `extension` is the usual one of `extensions`. `reads`: it can be opened; the others: it can
/// be saved, `drawing` with segments, `points` without, `quadratic` a mesh of six nodes. A mesh, its cells and
/// its report have `save`, `saveCells` and `saveReport`.
#[wasm_bindgen]
pub fn formats() -> String {
    let files = Format::ALL
        .into_iter()
        .filter(|f| f.is_built())
        .map(Row::of);
    let logs = LogFormat::ALL.into_iter().map(Row::of_log);
    json::write(&files.chain(logs).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use crate::mesh::Mesh;
    use crate::play::Player;
    use crate::save::SavedFile;

    type Saved = Result<Vec<SavedFile>, crate::Trouble>;

    /// What is listed can be saved, and nothing else can.
    #[test]
    fn lists_say_what_is_so() {
        let lake = Drawing::preset("lake", 0, 0).expect("a preset");
        let mut bare = Drawing::preset("uniform", 9, 1).expect("points");
        let lines = Drawing::new(&bare.points(), &[0, 1], &[]).expect("a drawing");
        let mesh = Mesh::refine(&lake, None, None).expect("a mesh");
        let player = Player::run("incremental", &bare, None, None).expect("a run");
        bare.edit(r#"[{"addPoint": [9, 9]}]"#).expect("an edit");
        let rows = Format::ALL
            .into_iter()
            .filter(|f| f.is_built())
            .map(Row::of);
        for row in rows.chain(LogFormat::ALL.map(Row::of_log)) {
            assert!(!row.what.is_empty());
            let name = format!("a.{}", row.extension);
            let agrees = |listed: bool, saved: Saved| assert_eq!(listed, saved.is_ok(), "{name}");
            if row.extension != "json" {
                agrees(row.drawing, lines.save(&name, None));
                agrees(row.points, bare.save(&name, None));
                agrees(row.mesh, mesh.save(&name, None));
                let nodes = r#"{"quadratic": true}"#.to_owned();
                agrees(row.quadratic, mesh.save(&name, Some(nodes)));
                agrees(row.cells, mesh.save_cells(&name, None));
                agrees(row.report, mesh.save_report(&name, "lake"));
            }
            agrees(
                row.run,
                player.save(&name, Some(r#"{"size": 200}"#.to_owned())),
            );
        }
    }
}
