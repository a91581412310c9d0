//! `.svg`: a picture of lines and areas.
//!
//! Triangles are grouped by colour and edges by width, one path each, with coordinates to a tenth of
//! a pixel: about 20 bytes a triangle. Beyond [`MAX_SHAPES`] triangles no viewer is quick any more,
//! and the drawing goes in as an embedded image of pixels; the legend stays lines.

mod basic;
mod path;
mod read;
mod transform;
mod tree;

pub(crate) use read::{read_domain, sniff};

use crate::picture::cells::{CellScene, color_of};
use crate::picture::domain::{BAND_OPACITY, BAND_WIDTH, Band, RING};
use crate::picture::glyphs::Stroke;
use crate::picture::sheet::{Shape, Sheet};
use crate::picture::{CLASSES, Color, EdgeClass, INK, PAPER, Scene};
use crate::png;
use crate::target::Output;
use crate::{Error, MeshView, PictureOptions};
use base64::prelude::{BASE64_STANDARD, Engine};
use delone::Watch;
use std::fmt::Write;

/// Most triangles, or bare points, that are drawn one by one.
const MAX_SHAPES: usize = 200_000;

/// Draws a mesh.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    options: &PictureOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let scene = Scene::new(out.file(), mesh, options, watch)?;
    write_marked(out, &scene, &[])
}

/// Draws a mesh, and sheets upon it.
pub(crate) fn write_marked(
    out: &mut Output<'_>,
    scene: &Scene<'_>,
    sheets: &[Sheet],
) -> Result<(), Error> {
    let [width, height] = scene.view.page;
    out.text(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{}</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
        scene.title(),
        PAPER.hex()
    ))?;
    write_drawing(out, scene)?;
    for sheet in sheets {
        write_sheet(out, sheet, &INK.hex())?;
    }
    out.text(format_args!("</svg>\n"))
}

/// Writes the mesh and its legend.
pub(crate) fn write_drawing(out: &mut Output<'_>, scene: &Scene<'_>) -> Result<(), Error> {
    if scene.num_shapes() > MAX_SHAPES {
        write_image(out, scene)?;
    } else {
        write_shapes(out, scene)?;
    }
    if let Some(legend) = scene.sheet_of_legend() {
        write_sheet(out, &legend, &INK.hex())?;
    }
    Ok(())
}

/// Draws Voronoi cells: those of one colour in one path, their outlines upon them.
pub(crate) fn write_cells(out: &mut Output<'_>, scene: &CellScene<'_>) -> Result<(), Error> {
    let [width, height] = scene.view.page;
    out.text(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <title>{} Voronoi cells</title>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
        scene.number(),
        PAPER.hex()
    ))?;
    if scene.number() > MAX_SHAPES {
        write_pixels(out, scene.view.page, &png::encode_cells(scene)?)?;
    } else {
        write_cell_shapes(out, scene)?;
    }
    if let Some(legend) = scene.legend() {
        write_sheet(out, &legend, &INK.hex())?;
    }
    out.text(format_args!("</svg>\n"))
}

fn write_cell_shapes(out: &mut Output<'_>, scene: &CellScene<'_>) -> Result<(), Error> {
    let mut paths = vec![String::new(); CLASSES];
    scene.each_part(|rings, class| {
        for ring in rings {
            push_move(&mut paths[class], ring[0]);
            let pairs = ring.windows(2);
            pairs.for_each(|pair| push_line(&mut paths[class], pair[0], pair[1]));
            paths[class].push('z');
        }
        Ok(())
    })?;
    // Without outlines, a thin one of the same colour closes the seams.
    let (width, opacity) = scene.outline().unwrap_or((0.5 * scene.unit, 1.0));
    let has_outlines = scene.outline().is_some();
    out.text(format_args!(
        "<g fill-rule=\"evenodd\" stroke-width=\"{width:.2}\" stroke-opacity=\"{opacity:.2}\" stroke-linejoin=\"round\">\n"
    ))?;
    for (class, path) in paths.iter().enumerate() {
        if path.is_empty() {
            continue;
        }
        let fill = color_of(class);
        let stroke = if has_outlines { INK } else { fill };
        let [fill, stroke] = [fill, stroke].map(Color::hex);
        out.text(format_args!(
            "<path fill=\"{fill}\" stroke=\"{stroke}\" d=\""
        ))?;
        out.many_bytes(path.as_bytes())?;
        out.text(format_args!("\"/>\n"))?;
    }
    out.text(format_args!("</g>\n"))?;
    match scene.dots() {
        Some((dots, radius)) => write_dots(out, dots.into_iter(), radius, INK),
        None => Ok(()),
    }
}

fn write_shapes(out: &mut Output<'_>, scene: &Scene<'_>) -> Result<(), Error> {
    write_triangles(out, scene)?;
    for (i, band) in scene.bands()?.iter().enumerate() {
        write_band(out, scene, i, band)?;
    }
    for class in scene.edges()? {
        write_edges(out, &class, INK)?;
    }
    if let Some(outlined) = scene.outlined()? {
        write_edges(out, &outlined, INK)?;
    }
    for (lines, color) in scene.segments()? {
        write_edges(out, &lines, color)?;
    }
    if let Some((dots, radius)) = scene.dots() {
        write_dots(out, dots, radius, INK)?;
    }
    if let Some((places, radius)) = scene.crossings() {
        let places: Vec<_> = places.collect();
        write_dots(out, places.iter().copied(), radius, INK)?;
        write_dots(out, places.into_iter(), RING * radius, PAPER)?;
    }
    Ok(())
}

fn write_image(out: &mut Output<'_>, scene: &Scene<'_>) -> Result<(), Error> {
    write_pixels(
        out,
        scene.view.page,
        &png::encode(&png::draw(scene)?, scene)?,
    )
}

/// Embeds a PNG that fills the page.
pub(crate) fn write_pixels(
    out: &mut Output<'_>,
    [width, height]: [f32; 2],
    image: &[u8],
) -> Result<(), Error> {
    let image = BASE64_STANDARD.encode(image);
    out.text(format_args!(
        "<image width=\"{width}\" height=\"{height}\" href=\"data:image/png;base64,"
    ))?;
    out.many_bytes(image.as_bytes())?;
    out.text(format_args!("\"/>\n"))
}

fn write_triangles(out: &mut Output<'_>, scene: &Scene<'_>) -> Result<(), Error> {
    let colors = scene.colors();
    let mut paths = vec![String::new(); colors.len()];
    scene.each_triangle(|[a, b, c], class| {
        let path = &mut paths[class];
        push_move(path, a);
        // Relative to the rounded corner before, so that rounding does not add up.
        push_line(path, a, b);
        push_line(path, b, c);
        path.push('z');
    })?;
    // Viewers blend the two sides of an edge with the paper; a thin outline closes the seam.
    let seam = 0.5 * scene.unit;
    out.text(format_args!(
        "<g stroke-width=\"{seam:.2}\" stroke-linejoin=\"round\">\n"
    ))?;
    let classes = colors.into_iter().zip(&paths);
    for (color, path) in classes.filter(|(_, path)| !path.is_empty()) {
        let color = color.hex();
        out.text(format_args!(
            "<path fill=\"{color}\" stroke=\"{color}\" d=\""
        ))?;
        out.many_bytes(path.as_bytes())?;
        out.text(format_args!("\"/>\n"))?;
    }
    out.text(format_args!("</g>\n"))
}

fn write_edges(out: &mut Output<'_>, class: &EdgeClass, color: Color) -> Result<(), Error> {
    if class.edges.is_empty() {
        return Ok(());
    }
    out.text(format_args!(
        "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\" stroke-opacity=\"{:.2}\" stroke-linecap=\"round\" d=\"",
        color.hex(),
        class.width,
        class.opacity
    ))?;
    let mut path = String::new();
    for &[a, b] in &class.edges {
        path.clear();
        push_move(&mut path, a);
        push_line(&mut path, a, b);
        out.bytes(path.as_bytes())?;
    }
    out.text(format_args!("\"/>\n"))
}

/// Writes the band along the inner side of regions: a line twice as wide, the outer half clipped.
fn write_band(
    out: &mut Output<'_>,
    scene: &Scene<'_>,
    number: usize,
    band: &Band,
) -> Result<(), Error> {
    out.text(format_args!(
        "<clipPath id=\"clip{number}\"><path id=\"border{number}\" d=\""
    ))?;
    let mut path = String::new();
    for line in &band.loops {
        path.clear();
        push_move(&mut path, line[0]);
        line.windows(2)
            .for_each(|w| push_line(&mut path, w[0], w[1]));
        path.push('z');
        out.bytes(path.as_bytes())?;
    }
    out.text(format_args!(
        "\"/></clipPath>\n\
         <use href=\"#border{number}\" clip-path=\"url(#clip{number})\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\" stroke-opacity=\"{BAND_OPACITY}\" stroke-linejoin=\"round\"/>\n",
        band.color.hex(),
        2.0 * BAND_WIDTH * scene.unit
    ))
}

/// A dot is a line without length and with a round cap: the shortest way to write many.
fn write_dots(
    out: &mut Output<'_>,
    dots: impl Iterator<Item = [f32; 2]>,
    radius: f32,
    color: Color,
) -> Result<(), Error> {
    out.text(format_args!(
        "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\" stroke-linecap=\"round\" d=\"",
        color.hex(),
        2.0 * radius
    ))?;
    let mut path = String::new();
    for dot in dots {
        path.clear();
        push_move(&mut path, dot);
        path.push_str("h0");
        out.bytes(path.as_bytes())?;
    }
    out.text(format_args!("\"/>\n"))
}

/// Writes the shapes of a sheet; `ink` is what stands for the colour of ink.
pub(crate) fn write_sheet(out: &mut Output<'_>, sheet: &Sheet, ink: &str) -> Result<(), Error> {
    let hue = |color: Color| match color {
        INK => ink.to_owned(),
        _ => color.hex(),
    };
    for alike in sheet.shapes.chunk_by(|a, b| a.is_bar() == b.is_bar()) {
        let rendering = match alike[0].is_bar() {
            true => " shape-rendering=\"crispEdges\"",
            false => "",
        };
        out.text(format_args!("<g{rendering}>\n"))?;
        for shape in alike {
            write_shape(out, shape, hue)?;
        }
        out.text(format_args!("</g>\n"))?;
    }
    Ok(())
}

fn write_shape(
    out: &mut Output<'_>,
    shape: &Shape,
    hue: impl Fn(Color) -> String,
) -> Result<(), Error> {
    match *shape {
        Shape::Bar {
            corner: [x, y],
            extent: [width, height],
            color,
        } => out.text(format_args!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{}\"/>\n",
            hue(color)
        )),
        Shape::Disc {
            center: [x, y],
            radius,
            color,
        } => out.text(format_args!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\" fill=\"{}\"/>\n",
            hue(color)
        )),
        Shape::Area { ref corners, color } => {
            out.text(format_args!("<path fill=\"{}\" d=\"", hue(color)))?;
            for (i, [x, y]) in corners.iter().enumerate() {
                let command = if i == 0 { 'M' } else { 'L' };
                out.text(format_args!("{command}{x:.1} {y:.1}"))?;
            }
            out.text(format_args!("z\"/>\n"))
        }
        Shape::Lines {
            ref path,
            width,
            color,
            opacity,
        } => {
            out.text(format_args!(
                "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{width:.2}\" stroke-opacity=\"{opacity:.2}\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"",
                hue(color)
            ))?;
            write_strokes(out, path)?;
            out.text(format_args!("\"/>\n"))
        }
    }
}

pub(crate) fn write_strokes(out: &mut Output<'_>, path: &[Stroke]) -> Result<(), Error> {
    path.iter().try_for_each(|stroke| match stroke {
        Stroke::Move([x, y]) => out.text(format_args!("M{x:.1} {y:.1}")),
        Stroke::Line([x, y]) => out.text(format_args!("L{x:.1} {y:.1}")),
        Stroke::Cubic([a, b, c]) => out.text(format_args!(
            "C{:.1} {:.1} {:.1} {:.1} {:.1} {:.1}",
            a[0], a[1], b[0], b[1], c[0], c[1]
        )),
    })
}

/// Rounds to tenths of a pixel, as an integer.
fn tenths(v: f32) -> i32 {
    (v * 10.0).round() as i32
}

fn push_move(path: &mut String, [x, y]: [f32; 2]) {
    path.push('M');
    push_tenths(path, tenths(x));
    path.push(' ');
    push_tenths(path, tenths(y));
}

fn push_line(path: &mut String, from: [f32; 2], to: [f32; 2]) {
    let [dx, dy] = [0, 1].map(|k| tenths(to[k]) - tenths(from[k]));
    path.push('l');
    push_tenths(path, dx);
    if dy >= 0 {
        path.push(' ');
    }
    push_tenths(path, dy);
}

/// Writes a number of tenths as shortly as SVG allows: `-.5`, `12`, `3.4`.
pub(crate) fn push_tenths(path: &mut String, tenths: i32) {
    if tenths < 0 {
        path.push('-');
    }
    let (whole, rest) = (tenths.unsigned_abs() / 10, tenths.unsigned_abs() % 10);
    let written = match (whole, rest) {
        (whole, 0) => write!(path, "{whole}"),
        (0, rest) => write!(path, ".{rest}"),
        _ => write!(path, "{whole}.{rest}"),
    };
    written.expect("bug: a string takes every character");
}
