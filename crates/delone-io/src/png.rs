//! `.png`: a picture of pixels, written only.
//!
//! Areas are filled by exact coverage (see [`accumulate`](crate::picture::accumulate)), lines and
//! dots drawn over them by `tiny-skia`, all anti-aliased.

use crate::picture::accumulate::Accumulator;
use crate::picture::cells::{CellScene, color_of};
use crate::picture::domain::{BAND_OPACITY, BAND_WIDTH, Band, RING};
use crate::picture::glyphs::Stroke as GlyphStroke;
use crate::picture::sheet::{Shape, Sheet};
use crate::picture::{Color, EdgeClass, INK, PAPER, Scene};
use crate::target::Output;
use crate::{Error, MeshView, PictureOptions};
use delone::Watch;
use std::io::Write;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap, PremultipliedColorU8,
    Stroke, Transform,
};

/// Edges or bare points drawn between two looks at the watch.
const SHAPES_PER_POLL: usize = 2048;

/// Lines from which on their round ends are not worth the time.
const MANY_LINES: usize = 20_000;

/// Draws a mesh.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    options: &PictureOptions,
    watch: &dyn Watch,
) -> Result<(), Error> {
    let scene = Scene::new(out.file(), mesh, options, watch)?;
    out.many_bytes(&encode(&draw_with_legend(&scene)?, &scene)?)
}

/// Draws a mesh, and sheets upon it.
pub(crate) fn write_marked(
    out: &mut Output<'_>,
    scene: &Scene<'_>,
    sheets: &[Sheet],
) -> Result<(), Error> {
    let mut page = draw_with_legend(scene)?;
    for sheet in sheets {
        draw_sheet(&mut page, sheet);
    }
    out.many_bytes(&encode(&page, scene)?)
}

/// Draws the mesh and its legend.
pub(crate) fn draw_with_legend(scene: &Scene<'_>) -> Result<Pixmap, Error> {
    let mut page = draw(scene)?;
    if let Some(legend) = scene.sheet_of_legend() {
        draw_sheet(&mut page, &legend);
    }
    Ok(page)
}

/// Draws Voronoi cells.
pub(crate) fn write_cells(out: &mut Output<'_>, scene: &CellScene<'_>) -> Result<(), Error> {
    let mut page = draw_cells(scene)?;
    if let Some(legend) = scene.legend() {
        draw_sheet(&mut page, &legend);
    }
    out.many_bytes(&pack(&page, scene.file, || scene.check())?)
}

/// Draws Voronoi cells without legend, and packs them.
pub(crate) fn encode_cells(scene: &CellScene<'_>) -> Result<Vec<u8>, Error> {
    pack(&draw_cells(scene)?, scene.file, || scene.check())
}

fn draw_cells(scene: &CellScene<'_>) -> Result<Pixmap, Error> {
    let mut areas = Accumulator::new(scene.view.page);
    let outline = scene.outline();
    let mut lines = PathBuilder::new();
    scene.each_part(|rings, class| {
        for ring in rings {
            // Holes run clockwise, and so take their area away.
            areas.add(ring, color_of(class));
            if outline.is_some() {
                push_loop(&mut lines, ring);
            }
        }
        Ok(())
    })?;
    let mut page = fill_page(areas, scene.view.page, || scene.check())?;
    if let Some((width, opacity)) = outline {
        let paint = paint(INK, opacity);
        stroke_path(&mut page, lines.finish(), &paint, &round_stroke(width));
    }
    if let Some((dots, radius)) = scene.dots() {
        for dot in dots {
            scene.check()?;
            draw_disc(&mut page, dot, radius, INK);
        }
    }
    Ok(page)
}

/// Packs the pixels.
pub(crate) fn encode(page: &Pixmap, scene: &Scene<'_>) -> Result<Vec<u8>, Error> {
    pack(page, scene.file(), || scene.check())
}

/// Packs the pixels of the picture `file`; `check` fails if cancelled.
pub(crate) fn pack(
    page: &Pixmap,
    file: &str,
    check: impl Fn() -> Result<(), Error>,
) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, page.width(), page.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let broken = |e: &dyn std::fmt::Display| Error::Picture {
        file: file.to_owned(),
        reason: e.to_string(),
    };
    let mut writer = encoder.write_header().map_err(|e| broken(&e))?;
    let mut rows = writer.stream_writer().map_err(|e| broken(&e))?;
    let mut row = Vec::new();
    for pixels in page.pixels().chunks(page.width() as usize) {
        check()?;
        row.clear();
        row.extend(pixels.iter().flat_map(|p| [p.red(), p.green(), p.blue()]));
        rows.write_all(&row).map_err(|e| broken(&e))?;
    }
    rows.finish().map_err(|e| broken(&e))?;
    writer.finish().map_err(|e| broken(&e))?;
    Ok(bytes)
}

/// Draws everything but the legend.
pub(crate) fn draw(scene: &Scene<'_>) -> Result<Pixmap, Error> {
    let mut page = draw_areas(scene)?;
    for band in scene.bands()? {
        draw_band(&mut page, scene, &band)?;
    }
    for class in scene.edges()? {
        draw_edges(&mut page, scene, &class, INK)?;
    }
    if let Some(outlined) = scene.outlined()? {
        draw_edges(&mut page, scene, &outlined, INK)?;
    }
    for (lines, color) in scene.segments()? {
        if lines.edges.len() > MANY_LINES {
            draw_many_lines(&mut page, scene, &lines, color)?;
        } else {
            draw_edges(&mut page, scene, &lines, color)?;
        }
    }
    if !scene.is_bare()
        && let Some((dots, radius)) = scene.dots()
    {
        draw_discs(&mut page, scene, dots, radius, INK)?;
    }
    if let Some((places, radius)) = scene.crossings() {
        let places: Vec<_> = places.collect();
        draw_discs(&mut page, scene, places.iter().copied(), radius, INK)?;
        let inner = RING * radius;
        draw_discs(&mut page, scene, places.into_iter(), inner, PAPER)?;
    }
    Ok(page)
}

/// Draws lines by the area that they cover: with square ends, but ten times as fast.
fn draw_many_lines(
    page: &mut Pixmap,
    scene: &Scene<'_>,
    lines: &EdgeClass,
    color: Color,
) -> Result<(), Error> {
    let mut areas = Accumulator::new(scene.view.page);
    for (i, &line) in lines.edges.iter().enumerate() {
        if i.is_multiple_of(SHAPES_PER_POLL) {
            scene.check()?;
        }
        areas.add_line(line, lines.width, color);
    }
    let color = color.bytes();
    let width = page.width() as usize;
    let mut coverage = areas.into_coverage();
    for row in page.pixels_mut().chunks_mut(width) {
        scene.check()?;
        for (pixel, covered) in row.iter_mut().zip(&mut coverage) {
            let share = covered * lines.opacity;
            let below = [pixel.red(), pixel.green(), pixel.blue()];
            let mix = |k: usize| {
                let [above, below] = [color[k], below[k]].map(f32::from);
                (below + (above - below) * share).round() as u8
            };
            *pixel = PremultipliedColorU8::from_rgba(mix(0), mix(1), mix(2), u8::MAX)
                .expect("bug: opaque");
        }
    }
    Ok(())
}

/// Draws the band along the inner side of regions: a line twice as wide, the outer half masked.
fn draw_band(page: &mut Pixmap, scene: &Scene<'_>, band: &Band) -> Result<(), Error> {
    scene.check()?;
    let mut builder = PathBuilder::new();
    for line in &band.loops {
        push_loop(&mut builder, line);
    }
    let mask = Mask::new(page.width(), page.height());
    if let (Some(path), Some(mut mask)) = (builder.finish(), mask) {
        mask.fill_path(&path, FillRule::Winding, true, Transform::identity());
        scene.check()?;
        let stroke = round_stroke(2.0 * BAND_WIDTH * scene.unit);
        let paint = paint(band.color, BAND_OPACITY);
        page.stroke_path(&path, &paint, &stroke, Transform::identity(), Some(&mask));
    }
    Ok(())
}

/// Draws the triangles, or bare points: few or millions, at the same cost for each.
fn draw_areas(scene: &Scene<'_>) -> Result<Pixmap, Error> {
    let mut areas = Accumulator::new(scene.view.page);
    let colors = scene.colors();
    scene.each_triangle(|corners, class| areas.add(&corners, colors[class]))?;
    if scene.is_bare()
        && let Some((dots, radius)) = scene.dots()
    {
        for (i, dot) in dots.enumerate() {
            if i.is_multiple_of(SHAPES_PER_POLL) {
                scene.check()?;
            }
            areas.add(&disc(dot, radius), INK);
        }
    }
    fill_page(areas, scene.view.page, || scene.check())
}

/// Makes a page on which nothing is drawn yet.
pub(crate) fn empty_page(page: [f32; 2]) -> Pixmap {
    let [width, height] = page.map(|v| v as u32);
    let mut page = Pixmap::new(width, height).expect("bug: the page has a size");
    page.fill(tiny_skia::Color::WHITE);
    page
}

/// Turns areas into pixels; `check` fails if cancelled.
fn fill_page(
    areas: Accumulator,
    page: [f32; 2],
    check: impl Fn() -> Result<(), Error>,
) -> Result<Pixmap, Error> {
    let [width, height] = page.map(|v| v as u32);
    let mut page = Pixmap::new(width, height).expect("bug: the page has a size");
    let mut colors = areas.into_pixels();
    for row in page.pixels_mut().chunks_mut(width as usize) {
        check()?;
        for (pixel, color) in row.iter_mut().zip(&mut colors) {
            let [r, g, b] = color.bytes();
            *pixel = PremultipliedColorU8::from_rgba(r, g, b, u8::MAX).expect("bug: opaque");
        }
    }
    Ok(page)
}

/// Returns a polygon that looks like a disc.
fn disc([x, y]: [f32; 2], radius: f32) -> Vec<[f32; 2]> {
    let corners = if radius < 1.5 { 6 } else { 20 };
    let corner = |i| {
        let (sin, cos) = (i as f32 / corners as f32 * std::f32::consts::TAU).sin_cos();
        [x + radius * cos, y - radius * sin]
    };
    (0..corners).map(corner).collect()
}

fn draw_edges(
    page: &mut Pixmap,
    scene: &Scene<'_>,
    class: &EdgeClass,
    color: Color,
) -> Result<(), Error> {
    let paint = paint(color, class.opacity);
    let stroke = round_stroke(class.width);
    for edges in class.edges.chunks(SHAPES_PER_POLL) {
        scene.check()?;
        let mut path = PathBuilder::with_capacity(2 * edges.len(), 2 * edges.len());
        for &[[x0, y0], [x1, y1]] in edges {
            path.move_to(x0, y0);
            path.line_to(x1, y1);
        }
        stroke_path(page, path.finish(), &paint, &stroke);
    }
    Ok(())
}

fn draw_discs(
    page: &mut Pixmap,
    scene: &Scene<'_>,
    places: impl Iterator<Item = [f32; 2]>,
    radius: f32,
    color: Color,
) -> Result<(), Error> {
    for [x, y] in places {
        scene.check()?;
        draw_disc(page, [x, y], radius, color);
    }
    Ok(())
}

fn draw_disc(page: &mut Pixmap, [x, y]: [f32; 2], radius: f32, color: Color) {
    if let Some(path) = PathBuilder::from_circle(x, y, radius) {
        let paint = paint(color, 1.0);
        let identity = Transform::identity();
        page.fill_path(&path, &paint, FillRule::Winding, identity, None);
    }
}

/// Draws the shapes of a sheet.
pub(crate) fn draw_sheet(page: &mut Pixmap, sheet: &Sheet) {
    for shape in &sheet.shapes {
        draw_shape(page, shape);
    }
}

fn draw_shape(page: &mut Pixmap, shape: &Shape) {
    match *shape {
        Shape::Bar {
            corner: [x, y],
            extent: [width, height],
            color,
        } => {
            let (right, bottom) = (x + width, y + height);
            fill(
                page,
                &[[x, y], [right, y], [right, bottom], [x, bottom]],
                color,
            );
        }
        Shape::Disc {
            center,
            radius,
            color,
        } => draw_disc(page, center, radius, color),
        Shape::Area { ref corners, color } => fill(page, corners, color),
        Shape::Lines {
            ref path,
            width,
            color,
            opacity,
        } => {
            let paint = paint(color, opacity);
            stroke_path(page, path_of(path), &paint, &round_stroke(width));
        }
    }
}

/// Fills a polygon; also a rectangle, for `fill_rect` has no answer to some that are less than a pixel.
fn fill(page: &mut Pixmap, corners: &[[f32; 2]], color: Color) {
    let mut builder = PathBuilder::new();
    push_loop(&mut builder, corners);
    // A polygon without extent is none.
    if let Some(path) = builder.finish() {
        let paint = paint(color, 1.0);
        let identity = Transform::identity();
        page.fill_path(&path, &paint, FillRule::Winding, identity, None);
    }
}

fn push_loop(path: &mut PathBuilder, corners: &[[f32; 2]]) {
    for (i, &[x, y]) in corners.iter().enumerate() {
        match i {
            0 => path.move_to(x, y),
            _ => path.line_to(x, y),
        }
    }
    path.close();
}

/// Makes a path of strokes; one without extent is none.
pub(crate) fn path_of(strokes: &[GlyphStroke]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for stroke in strokes {
        match *stroke {
            GlyphStroke::Move([x, y]) => path.move_to(x, y),
            GlyphStroke::Line([x, y]) => path.line_to(x, y),
            GlyphStroke::Cubic([a, b, c]) => path.cubic_to(a[0], a[1], b[0], b[1], c[0], c[1]),
        }
    }
    path.finish()
}

fn stroke_path(page: &mut Pixmap, path: Option<Path>, paint: &Paint<'_>, stroke: &Stroke) {
    // A path without extent is none; there is nothing to see of it.
    if let Some(path) = path {
        page.stroke_path(&path, paint, stroke, Transform::identity(), None);
    }
}

pub(crate) fn paint(Color([r, g, b]): Color, opacity: f32) -> Paint<'static> {
    let mut paint = Paint::default();
    if let Some(color) = tiny_skia::Color::from_rgba(r, g, b, opacity) {
        paint.set_color(color);
    }
    paint
}

pub(crate) fn round_stroke(width: f32) -> Stroke {
    Stroke {
        width,
        line_cap: LineCap::Round,
        line_join: LineJoin::Round,
        ..Stroke::default()
    }
}
