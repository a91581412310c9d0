//! A report as one picture: headline, mesh with legend, histograms, figures.

use super::chart::Chart;
use super::figures::{self, Figure};
use super::{ReportOptions, Subject};
use crate::picture::sheet::{Anchor, Sheet};
use crate::picture::{INK, PAPER, Scene};
use crate::target::Output;
use crate::{Error, png, svg};
use quick_xml::escape::escape;
use tiny_skia::{Pixmap, PixmapPaint, Transform};

/// Height of the headline, and the margin, in pixels of the usual size.
const HEAD: f32 = 116.0;
const MARGIN: f32 = 56.0;

/// Height of a panel with a chart or figures.
const PANEL: f32 = 430.0;

/// Width of the panels if they stand beside a tall picture.
const COLUMN: f32 = 560.0;

/// Pictures at least as wide as this have the panels below.
const WIDE: f32 = 1200.0;

/// Where things lie.
struct Layout {
    /// Extent of the page.
    page: [f32; 2],
    /// Corner of the picture.
    picture: [f32; 2],
    /// Corners of the panels.
    panels: [[f32; 2]; 3],
    /// Extent of a panel.
    panel: [f32; 2],
    unit: f32,
}

impl Layout {
    fn new([width, height]: [f32; 2], unit: f32) -> Self {
        let [head, margin, panel] = [HEAD, MARGIN, PANEL].map(|v| (v * unit).round());
        if width >= WIDE * unit {
            let each = (width - 4.0 * margin) / 3.0;
            let at = |i: usize| [margin + i as f32 * (each + margin), head + height];
            return Self {
                page: [width, head + height + panel + margin],
                picture: [0.0, head],
                panels: [at(0), at(1), at(2)],
                panel: [each, panel],
                unit,
            };
        }
        let each = (COLUMN * unit).round();
        let at = |i: usize| [width, head + i as f32 * (panel + margin)];
        Self {
            page: [
                width + each + margin,
                head + height.max(3.0 * (panel + margin)),
            ],
            picture: [0.0, head],
            panels: [at(0), at(1), at(2)],
            panel: [each, panel],
            unit,
        }
    }
}

/// Writes the page as SVG.
pub(super) fn write_svg(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    options: &ReportOptions<'_>,
) -> Result<(), Error> {
    let scene = Scene::new(out.file(), subject.mesh, &options.picture, subject.watch)?;
    let layout = Layout::new(scene.view.page, scene.unit);
    let [width, height] = layout.page;
    out.text(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{}</title>\n\
         <desc>{}</desc>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
        escape(options.name),
        escape(in_words(subject)),
        PAPER.hex()
    ))?;
    let ([x, y], [width, height]) = (layout.picture, scene.view.page);
    out.text(format_args!(
        "<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\">\n"
    ))?;
    svg::write_drawing(out, &scene)?;
    out.text(format_args!("</svg>\n"))?;
    svg::write_sheet(out, &sheet(subject, options, &layout), &INK.hex())?;
    out.text(format_args!("</svg>\n"))
}

/// Writes the page as PNG.
pub(super) fn write_png(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    options: &ReportOptions<'_>,
) -> Result<(), Error> {
    let scene = Scene::new(out.file(), subject.mesh, &options.picture, subject.watch)?;
    let layout = Layout::new(scene.view.page, scene.unit);
    let [width, height] = layout.page.map(|v| v.ceil() as u32);
    let mut page = Pixmap::new(width, height).expect("bug: the page has a size");
    page.fill(tiny_skia::Color::WHITE);
    let picture = png::draw_with_legend(&scene)?;
    let [x, y] = layout.picture.map(|v| v as i32);
    let (paint, identity) = (PixmapPaint::default(), Transform::identity());
    page.draw_pixmap(x, y, picture.as_ref(), &paint, identity, None);
    png::draw_sheet(&mut page, &sheet(subject, options, &layout));
    out.many_bytes(&png::encode(&page, &scene)?)
}

/// Says everything that the page shows, for those who cannot see it.
fn in_words(subject: &Subject<'_>) -> String {
    let report = &subject.refined.report;
    let mut text = format!("{} {}", figures::asked(report), figures::outcome(report));
    for Figure { name, value, .. } in figures::principal(subject.refined) {
        text.push_str(&format!(" {name}: {value}."));
    }
    text
}

/// Draws everything but the mesh.
fn sheet(subject: &Subject<'_>, options: &ReportOptions<'_>, layout: &Layout) -> Sheet {
    let report = &subject.refined.report;
    let (found, asked) = (subject.refined.statistics(), &report.asked);
    let mut sheet = Sheet::default();
    let unit = layout.unit;
    let lines = [
        (options.name.to_owned(), 4.0, 50.0),
        (figures::asked(report), 2.1, 84.0),
        (figures::outcome(report), 2.1, 110.0),
    ];
    for (text, size, y) in lines {
        let start = [MARGIN * unit, y * unit];
        sheet.text(&text, start, size * unit, Anchor::Start, INK);
    }
    let charts = [
        Chart::of_angles(found, asked),
        Chart::of_edges(found, asked),
    ];
    for (chart, corner) in charts.iter().zip(layout.panels) {
        chart.draw(&mut sheet, corner, layout.panel, unit);
    }
    let figures = figures::principal(subject.refined);
    draw_figures(&mut sheet, &figures, layout);
    sheet
}

/// Draws the table of figures.
fn draw_figures(sheet: &mut Sheet, figures: &[Figure], layout: &Layout) {
    let unit = layout.unit;
    let [x, y] = layout.panels[2];
    let right = x + layout.panel[0] - 18.0 * unit;
    sheet.text(
        "Figures",
        [x, y + 20.0 * unit],
        2.4 * unit,
        Anchor::Start,
        INK,
    );
    let mut base = y + 62.0 * unit;
    for figure in figures {
        sheet.text(&figure.name, [x, base], 2.0 * unit, Anchor::Start, INK);
        sheet.text(&figure.value, [right, base], 2.0 * unit, Anchor::End, INK);
        if let Some(asked) = &figure.asked {
            base += 22.0 * unit;
            let asked = format!("asked: {asked}");
            sheet.text(&asked, [right, base], 1.6 * unit, Anchor::End, INK);
        }
        let line = [[x, base + 11.0 * unit], [right, base + 11.0 * unit]];
        sheet.line(line, 1.0 * unit, INK, 0.16);
        base += 36.0 * unit;
    }
}
