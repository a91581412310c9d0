//! A report as a page for the browser, with everything in it.
//!
//! It is well-formed XML too. Letters of charts are lines, as in all pictures, and take the colour of
//! the text, so that they suit light and dark pages; pictures of meshes keep their paper.

use super::chart::Chart;
use super::figures::{self, Figure};
use super::unmet::{self, Group};
use super::{ReportOptions, Subject, zoom};
use crate::picture::sheet::Sheet;
use crate::picture::{INK, PAPER, Scene};
use crate::target::Output;
use crate::words::counted;
use crate::{Error, Explainer, PictureOptions, png, svg};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::{Reason, Unmet};
use quick_xml::escape::escape;

const STYLE: &str = include_str!("style.css");

/// Most triangles, points and segments for a picture of lines; of more it is made of pixels.
const MOST_SHAPES: usize = 20_000;

/// Longest side of a picture of pixels, and of lines.
const MOST_PIXELS: u32 = 2000;

/// Unmet triangles that are enlarged.
const ENLARGED: usize = 24;

/// Width and height of a chart, in pixels.
const CHART: [f32; 2] = [520.0, 360.0];

/// Writes the page.
pub(super) fn write(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    options: &ReportOptions<'_>,
) -> Result<(), Error> {
    let report = &subject.refined.report;
    let name = escape(options.name);
    out.text(format_args!(
        "<!DOCTYPE html>\n\
         <html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n\
         <head>\n\
         <meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <meta name=\"color-scheme\" content=\"light dark\"/>\n\
         <meta name=\"generator\" content=\"delone {}\"/>\n\
         <title>{name} – mesh report</title>\n\
         <style>\n{STYLE}</style>\n\
         </head>\n<body>\n<main>\n\
         <header>\n<h1>{name}</h1>\n<p class=\"asked\">{}</p>\n<p class=\"outcome {}\">{}</p>\n</header>\n",
        env!("CARGO_PKG_VERSION"),
        escape(figures::asked(report)),
        if report.num_unexcused() == 0 { "good" } else { "bad" },
        escape(figures::outcome(report)),
    ))?;
    write_tiles(out, &figures::principal(subject.refined))?;
    write_picture(out, subject, options)?;
    write_charts(out, subject)?;
    write_unmet(out, subject, options)?;
    write_figures(out, subject, options)?;
    out.text(format_args!("</main>\n</body>\n</html>\n"))
}

/// Writes the principal figures, large.
fn write_tiles(out: &mut Output<'_>, figures: &[Figure]) -> Result<(), Error> {
    out.text(format_args!("<dl class=\"tiles\">\n"))?;
    for Figure { name, value, asked } in figures {
        let [name, value] = [name, value].map(escape);
        out.text(format_args!("<div><dt>{name}</dt><dd>{value}</dd>"))?;
        if let Some(asked) = asked {
            out.text(format_args!(
                "<dd class=\"bound\">asked: {}</dd>",
                escape(asked)
            ))?;
        }
        out.text(format_args!("</div>\n"))?;
    }
    out.text(format_args!("</dl>\n"))
}

/// Writes the picture of the mesh: as lines if there are few, else as pixels.
fn write_picture(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    options: &ReportOptions<'_>,
) -> Result<(), Error> {
    let picture = PictureOptions {
        size: options.picture.size.min(MOST_PIXELS),
        ..options.picture
    };
    let scene = Scene::new(out.file(), subject.mesh, &picture, subject.watch)?;
    let [width, height] = scene.view.page;
    let text = format!(
        "the mesh, {} coloured by their smallest angle",
        counted(scene.num_triangles(), "triangle", "triangles")
    );
    out.text(format_args!("<figure class=\"mesh\">\n"))?;
    if scene.num_shapes() > MOST_SHAPES {
        let image = BASE64_STANDARD.encode(png::encode(&png::draw_with_legend(&scene)?, &scene)?);
        out.text(format_args!(
            "<img width=\"{width}\" height=\"{height}\" alt=\"{text}\" src=\"data:image/png;base64,"
        ))?;
        out.many_bytes(image.as_bytes())?;
        out.text(format_args!("\"/>\n"))?;
    } else {
        open_svg(out, [width, height], &text)?;
        out.text(format_args!(
            "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
            PAPER.hex()
        ))?;
        svg::write_drawing(out, &scene)?;
        out.text(format_args!("</svg>\n"))?;
    }
    out.text(format_args!("</figure>\n"))
}

fn write_charts(out: &mut Output<'_>, subject: &Subject<'_>) -> Result<(), Error> {
    let (found, asked) = (subject.refined.statistics(), &subject.refined.report.asked);
    let charts = [
        Chart::of_smallest_angles,
        Chart::of_angles,
        Chart::of_edges,
        Chart::of_areas,
    ];
    out.text(format_args!("<section class=\"charts\">\n"))?;
    for chart in charts.map(|chart| chart(found, asked)) {
        let mut sheet = Sheet::default();
        // Letters begin on the line where they are put, and lines are wide.
        chart.draw(&mut sheet, [2.0, 0.0], CHART, 1.0);
        out.text(format_args!("<figure>\n"))?;
        open_svg(out, CHART, &chart.in_words())?;
        svg::write_sheet(out, &sheet, "currentColor")?;
        out.text(format_args!("</svg>\n</figure>\n"))?;
    }
    out.text(format_args!("</section>\n"))
}

/// Writes the other figures, and how the mesh was made.
fn write_figures(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    options: &ReportOptions<'_>,
) -> Result<(), Error> {
    out.text(format_args!("<section>\n<h2>Figures</h2>\n"))?;
    write_list(out, "figures", &figures::further(subject.refined))?;
    out.text(format_args!("<p class=\"note\">Lengths and areas are in units of the coordinates. Aspect: the longest edge divided by the height upon it, 1.155 at best.</p>\n</section>\n"))?;
    let details = figures::details(options);
    if details.is_empty() {
        return Ok(());
    }
    out.text(format_args!("<section>\n<h2>How it was made</h2>\n"))?;
    write_list(out, "details", &details)?;
    out.text(format_args!("</section>\n"))
}

fn write_list(out: &mut Output<'_>, class: &str, figures: &[Figure]) -> Result<(), Error> {
    out.text(format_args!("<dl class=\"{class}\">\n"))?;
    for Figure { name, value, .. } in figures {
        let [name, value] = [name, value].map(escape);
        out.text(format_args!("<div><dt>{name}</dt><dd>{value}</dd></div>\n"))?;
    }
    out.text(format_args!("</dl>\n"))
}

fn write_unmet(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    options: &ReportOptions<'_>,
) -> Result<(), Error> {
    let groups = unmet::groups(subject.refined, ENLARGED);
    if groups.is_empty() {
        return Ok(());
    }
    let from = match options.base {
        0 => "from 0",
        _ => "as in the file of the input",
    };
    out.text(format_args!(
        "<section>\n<h2>Unmet triangles</h2>\n\
         <p class=\"note\">The worst of each kind, enlarged: the triangle in red, segments in heavy lines. Vertices and segments of the input are numbered {from}.</p>\n"
    ))?;
    for group in &groups {
        write_group(out, subject, group, options.base)?;
    }
    out.text(format_args!("</section>\n"))
}

fn write_group(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    group: &Group<'_>,
    base: usize,
) -> Result<(), Error> {
    let number = counted(group.unmet.len(), "triangle", "triangles");
    let excused = if group.is_excused { ", excused" } else { "" };
    out.text(format_args!(
        "<h3>{}: {number}{excused}</h3>\n<p>{}</p>\n<div class=\"zooms\">\n",
        group.title, group.meaning
    ))?;
    for unmet in &group.unmet[..group.shown] {
        write_zoom(out, subject, unmet, base)?;
    }
    out.text(format_args!("</div>\n"))?;
    if let Some(rest) = unmet::rest(group) {
        out.text(format_args!("<p class=\"rest\">… {rest}</p>\n"))?;
    }
    Ok(())
}

fn write_zoom(
    out: &mut Output<'_>,
    subject: &Subject<'_>,
    unmet: &Unmet,
    base: usize,
) -> Result<(), Error> {
    let explainer = Explainer::new(subject.refined, base);
    let [lack, place] = [explainer.lack(unmet), explainer.place(unmet)];
    let broken = format!("{lack} at {place}");
    // Of other reasons the headline of the group says all.
    let reason = match unmet.reason {
        Reason::SmallInputAngle { .. } => explainer.reason(unmet.reason),
        _ => String::new(),
    };
    out.text(format_args!("<figure>\n"))?;
    open_svg(out, [zoom::SIZE; 2], &broken)?;
    svg::write_sheet(out, &zoom::zoom(subject.refined, unmet), &INK.hex())?;
    out.text(format_args!(
        "</svg>\n<figcaption><b>{}</b><br/>{}</figcaption>\n</figure>\n",
        escape(broken.as_str()),
        escape(reason.as_str())
    ))
}

fn open_svg(out: &mut Output<'_>, [width, height]: [f32; 2], label: &str) -> Result<(), Error> {
    out.text(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\n",
        escape(label)
    ))
}
