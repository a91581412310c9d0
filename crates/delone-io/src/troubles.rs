//! Troubles of a drawing, shown where they are: numbered marks on its picture, or features of GeoJSON.

use crate::picture::legend::TEXT;
use crate::picture::sheet::{Anchor, Sheet};
use crate::picture::{Color, INK, PAPER, Page, Scene, View};
use crate::points::unsupported;
use crate::target::{Output, Staging};
use crate::{
    Constraints, Error, Format, MeshView, PictureOptions, Target, cancel, geojson, png, svg,
};
use delone::doctor::Severity;
use delone::{Point, VertexId, Watch};
use std::path::PathBuf;

/// Most marks that have their number beside them; all are there.
const MOST_NUMBERS: usize = 120;

/// Most lines of the legend.
const MOST_LINES: usize = 22;

/// Width kept for the legend, as a share of the page.
const LEGEND: f32 = 0.24;

/// A trouble that is to be shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    /// Its number, which stands beside it.
    pub number: usize,
    /// What kind it is of, in a word that programs know.
    pub kind: &'static str,
    /// How bad that is.
    pub severity: Option<Severity>,
    /// What it is, in a sentence.
    pub text: String,
    /// The points that have part in it, in the numbers of their file.
    pub points: Vec<usize>,
    /// The segments, likewise.
    pub segments: Vec<usize>,
    /// The polygon, likewise.
    pub polygon: Option<usize>,
    /// A distance, angle or ratio.
    pub size: Option<f64>,
    /// Where it is; `None` if it is about the whole.
    pub at: Option<Point>,
    /// Where it ends, if it has an extent.
    pub to: Option<Point>,
}

/// A drawing and its troubles.
#[derive(Clone, Copy, Debug)]
pub struct TroublesView<'a> {
    /// The points.
    pub points: &'a [Point],
    /// The segments between them.
    pub segments: &'a [[VertexId; 2]],
    /// What is wrong, those of a kind together, the worst first.
    pub marks: &'a [Mark],
}

/// Shows troubles in every target and returns the names of the files written.
///
/// - `.svg` and `.png` show the segments, with a numbered ring at each trouble, a line where it has an extent,
///   and a legend;
/// - `.geojson` has a feature for each: a point, or a line where it has an extent, or no place.
///
/// ```
/// use delone_io::{Mark, PictureOptions, Target, TroublesView, write_troubles};
/// # let folder = tempfile::tempdir()?;
/// let points = [(0.0, 0.0), (3.0, 4.0)].map(Into::into);
/// let mark = Mark { number: 1, kind: "open_end", at: Some(points[1]), ..Mark::default() };
/// let view = TroublesView { points: &points, segments: &[[0.into(), 1.into()]], marks: &[mark] };
/// let targets = ["t.svg", "t.geojson"].map(|name| Target::from_arg(folder.path().join(name), None));
/// assert_eq!(write_troubles(&targets, &view, &PictureOptions::default(), &())?.len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a segment names no point, a target has another format, writing fails, or the watch cancels.
pub fn write_troubles(
    targets: &[Target],
    view: &TroublesView<'_>,
    options: &PictureOptions,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let constraints = Constraints {
        edges: view.segments.to_vec(),
        ..Constraints::default()
    };
    let mesh = MeshView::new(view.points, &[]).with_constraints(&constraints);
    mesh.validate()?;
    let mut staging = Staging::new((view.marks.len() * targets.len()) as u64, watch);
    for target in targets {
        let format = target.format()?;
        staging.write(target.path.as_deref(), |out| match format {
            Format::GeoJson => geojson::write_marks(out, view.marks),
            Format::Svg | Format::Png => {
                let mut scene = Scene::new(out.file(), &mesh, options, watch)?;
                make_room(&mut scene, view.points, options);
                let sheets = [
                    marks(&scene, view.marks, watch)?,
                    legend(&scene, view.marks),
                ];
                match format {
                    Format::Svg => svg::write_marked(out, &scene, &sheets),
                    _ => png::write_marked(out, &scene, &sheets),
                }
            }
            format => Err(unsupported(target, format, "show troubles", |f| {
                f.is_picture() || f == Format::GeoJson
            })),
        })?;
    }
    staging.commit()
}

/// Lays the page out again, with room for the legend.
fn make_room(scene: &mut Scene<'_>, points: &[Point], options: &PictureOptions) {
    let legend = LEGEND * options.size as f32;
    let page = Page::new(options.size as f32 - legend, false);
    let view = View::new(points, &page);
    let [width, height] = view.page;
    // High enough for all lines of the legend.
    let least = (MOST_LINES as f32 + 4.0) * 30.0 * scene.unit;
    let height = height.max(least).round();
    let [[left, _], extent] = view.drawing;
    let top = (height - extent[1]) / 2.0;
    let page = [(width + legend).round(), height];
    scene.view = View::within(points, page, [[left, top], extent]);
}

fn color(severity: Option<Severity>) -> Color {
    match severity {
        Some(Severity::Error) => Color([0.84, 0.10, 0.13]),
        Some(Severity::Warning) => Color([0.93, 0.50, 0.02]),
        _ => Color([0.16, 0.40, 0.82]),
    }
}

/// Draws the marks, the worst last, so that none hides it.
fn marks(scene: &Scene<'_>, marks: &[Mark], watch: &dyn Watch) -> Result<Sheet, Error> {
    let unit = scene.unit;
    let mut sheet = Sheet::default();
    for (i, mark) in marks.iter().enumerate().rev() {
        cancel::check(watch, i)?;
        let Some(center) = center(scene, mark) else {
            continue;
        };
        let color = color(mark.severity);
        if let (Some(at), Some(to)) = (mark.at, mark.to) {
            let ends = [at, to].map(|p| scene.view.place(p));
            sheet.line(ends, 5.0 * unit, color, 0.8);
        }
        for (radius, color) in [(11.0, PAPER), (9.5, color), (6.0, PAPER), (2.4, color)] {
            sheet.disc(center, radius * unit, color);
        }
    }
    for label in labels(scene, marks) {
        let [x, y] = label.beside;
        let start = [x + 14.0 * unit, y - 8.0 * unit];
        sheet.text(
            &label.text(),
            start,
            TEXT * unit,
            Anchor::Start,
            label.color,
        );
    }
    Ok(sheet)
}

/// Where a mark is on the page; a corner of the whole is no place.
fn center(scene: &Scene<'_>, mark: &Mark) -> Option<[f32; 2]> {
    let is_whole = mark.points.is_empty() && mark.segments.is_empty() && mark.to.is_some();
    let at = scene.view.place(mark.at.filter(|_| !is_whole)?);
    let to = mark.to.map_or(at, |to| scene.view.place(to));
    Some([0, 1].map(|k| (at[k] + to[k]) / 2.0))
}

/// The numbers of marks that lie upon each other.
struct Label {
    beside: [f32; 2],
    color: Color,
    numbers: Vec<usize>,
}

impl Label {
    fn text(&self) -> String {
        /// Most numbers of one label.
        const FEW: usize = 3;
        let words: Vec<String> = self
            .numbers
            .iter()
            .take(FEW)
            .map(usize::to_string)
            .collect();
        let more = if self.numbers.len() > FEW { " …" } else { "" };
        words.join(", ") + more
    }
}

/// Puts the numbers together of marks that lie upon each other, in the colour of the worst.
fn labels(scene: &Scene<'_>, marks: &[Mark]) -> Vec<Label> {
    let reach = 22.0 * scene.unit;
    let mut labels: Vec<Label> = Vec::new();
    for mark in marks.iter().take(MOST_NUMBERS) {
        let Some([x, y]) = center(scene, mark) else {
            continue;
        };
        let is_here = |label: &&mut Label| {
            (label.beside[0] - x).abs() < reach && (label.beside[1] - y).abs() < reach
        };
        match labels.iter_mut().find(is_here) {
            Some(label) => label.numbers.push(mark.number),
            None => labels.push(Label {
                beside: [x, y],
                color: color(mark.severity),
                numbers: vec![mark.number],
            }),
        }
    }
    labels
}

/// Lists the kinds, with their numbers.
fn legend(scene: &Scene<'_>, marks: &[Mark]) -> Sheet {
    let unit = scene.unit;
    let mut sheet = Sheet::default();
    let [corner, extent] = scene.view.drawing;
    let left = corner[0] + extent[0] + 60.0 * unit;
    let kinds: Vec<&[Mark]> = marks.chunk_by(|a, b| a.kind == b.kind).collect();
    let lines = kinds.len().clamp(1, MOST_LINES);
    let mut y = (scene.view.page[1] - lines as f32 * 30.0 * unit) / 2.0;
    let mut line = |mark: Option<Color>, text: &str| {
        if let Some(color) = mark {
            sheet.disc([left, y], 8.0 * unit, color);
        }
        let start = [left + 20.0 * unit, y + 3.0 * TEXT * unit];
        sheet.text(text, start, 0.85 * TEXT * unit, Anchor::Start, INK);
        y += 30.0 * unit;
    };
    if kinds.is_empty() {
        line(None, "no troubles");
    }
    for kind in kinds.iter().take(MOST_LINES) {
        let [first, last] = [&kind[0], &kind[kind.len() - 1]];
        let numbers = match kind.len() {
            1 => first.number.to_string(),
            _ => format!("{}–{}", first.number, last.number),
        };
        let text = format!("{numbers}  {}", first.kind.replace('_', " "));
        line(Some(color(first.severity)), &text);
    }
    sheet
}

/// Writes one feature's properties and geometry.
pub(crate) fn write_feature(out: &mut Output<'_>, mark: &Mark) -> Result<(), Error> {
    let severity = mark.severity.map(|severity| match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    });
    let properties = serde_json::json!({
        "number": mark.number,
        "kind": mark.kind,
        "severity": severity,
        "text": mark.text,
        "points": mark.points,
        "segments": mark.segments,
        "polygon": mark.polygon,
        "size": mark.size,
    });
    out.text(format_args!("{properties},\"geometry\":"))?;
    let position = |out: &mut Output<'_>, p: Point| {
        out.bytes(b"[")?;
        out.number(p.x);
        out.separator(b',');
        out.number(p.y);
        out.bytes(b"]")
    };
    match (mark.at, mark.to) {
        (Some(at), Some(to)) => {
            out.bytes(b"{\"type\":\"LineString\",\"coordinates\":[")?;
            position(out, at)?;
            out.bytes(b",")?;
            position(out, to)?;
            out.bytes(b"]}")
        }
        (Some(at), None) => {
            out.bytes(b"{\"type\":\"Point\",\"coordinates\":")?;
            position(out, at)?;
            out.bytes(b"}")
        }
        (None, _) => out.bytes(b"null"),
    }
}
