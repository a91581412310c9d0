//! `.tikz`, `.tex`: a picture for LaTeX, to be taken in with `\input`; the preamble needs `\usepackage{tikz}`.
//!
//! T. Tantau, *The TikZ and PGF Packages*, manual for version 3.1. The picture shows what SVG and PNG show
//! (triangles coloured by their smallest angle, segments, points), without legend, as lines and areas: TeX takes
//! its time, so that beyond [`MAX_SHAPES`] triangles it is refused. The longer side is 12 cm at the usual size of
//! pictures, and grows with it.

use crate::picture::domain::{BAND_OPACITY, BAND_WIDTH, RING};
use crate::picture::{Color, EdgeClass, INK, PAPER, Scene};
use crate::target::Output;
use crate::{Error, MeshView, PictureOptions, WriteOptions};

/// Most triangles, segments or bare points.
const MAX_SHAPES: usize = 20_000;

/// Most dots besides triangles.
const MAX_DOTS: usize = 5_000;

/// Centimetres of a pixel: 12 for the usual 1600, whose margins of 56 are left out.
const CM_PER_PIXEL: f32 = 12.0 / (1600.0 - 2.0 * 56.0);

/// Parts of a path that go into one command: TeX keeps a path in memory until its end.
const PARTS: usize = 200;

/// Draws a mesh, a domain or points.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    _markers: &[i32],
    options: &WriteOptions,
) -> Result<(), Error> {
    let options = PictureOptions {
        legend: false,
        ..options.picture.clone()
    };
    // So few shapes are drawn at once: nobody waits for them.
    let segments = mesh.constraints.map_or(0, |c| c.edges.len());
    let triangles = mesh.triangles.len();
    let points = mesh.counts.map_or(mesh.points, |held| held.data).len();
    let is_bare = triangles == 0 && segments == 0;
    for (count, what) in [
        (triangles, "triangles"),
        (segments, "segments"),
        (if is_bare { points } else { 0 }, "points"),
    ] {
        if count > MAX_SHAPES {
            let reason = format!(
                "{count} {what}, and LaTeX copes with {MAX_SHAPES}; write .svg or .png and include that"
            );
            let file = out.file().to_owned();
            return Err(Error::Picture { file, reason });
        }
    }
    let scene = Scene::new(out.file(), mesh, &options, &())?;
    let page = Page::new(&scene);
    out.text(format_args!(
        "% {}; the preamble needs \\usepackage{{tikz}}\n\\begin{{tikzpicture}}[line cap=round,line join=round]\n",
        scene.title()
    ))?;
    define(out, "ink", INK)?;
    define(out, "paper", PAPER)?;
    write_triangles(out, &scene, &page)?;
    write_bands(out, &scene, &page)?;
    for class in scene.edges()? {
        write_lines(out, &class, "ink", &page)?;
    }
    if let Some(outlined) = scene.outlined()? {
        write_lines(out, &outlined, "ink", &page)?;
    }
    for (lines, color) in scene.segments()? {
        let name = if color == PAPER { "paper" } else { "ink" };
        write_lines(out, &lines, name, &page)?;
    }
    if let Some((dots, radius)) = scene.dots()
        && (is_bare || points <= MAX_DOTS)
    {
        write_dots(out, dots, radius, "ink", &page)?;
    }
    if let Some((places, radius)) = scene.crossings() {
        let places: Vec<_> = places.collect();
        write_dots(out, places.iter().copied(), radius, "ink", &page)?;
        write_dots(out, places.into_iter(), RING * radius, "paper", &page)?;
    }
    out.text(format_args!("\\end{{tikzpicture}}\n"))
}

/// Maps pixels of the scene to centimetres, y up.
struct Page {
    left: f32,
    bottom: f32,
}

impl Page {
    fn new(scene: &Scene<'_>) -> Self {
        let [corner, extent] = scene.view.drawing;
        Self {
            left: corner[0],
            bottom: corner[1] + extent[1],
        }
    }

    /// Returns a length in points of TeX.
    fn points(pixels: f32) -> f32 {
        pixels * CM_PER_PIXEL * 28.452_76
    }

    fn place(&self, out: &mut Output<'_>, [x, y]: [f32; 2]) -> Result<(), Error> {
        let (x, y) = (
            (x - self.left) * CM_PER_PIXEL,
            (self.bottom - y) * CM_PER_PIXEL,
        );
        // No zero needs a sign.
        out.text(format_args!("({:.3},{:.3})", x + 0.0, y + 0.0))
    }

    fn path(
        &self,
        out: &mut Output<'_>,
        places: &[[f32; 2]],
        is_closed: bool,
    ) -> Result<(), Error> {
        for (i, &place) in places.iter().enumerate() {
            if i > 0 {
                out.text(format_args!("--"))?;
            }
            self.place(out, place)?;
        }
        out.text(format_args!("{}", if is_closed { "--cycle" } else { "" }))
    }
}

fn define(out: &mut Output<'_>, name: &str, color: Color) -> Result<(), Error> {
    let hex = color.hex().to_ascii_uppercase();
    let hex = hex.trim_start_matches('#');
    out.text(format_args!(
        "\\definecolor{{delone {name}}}{{HTML}}{{{hex}}}\n"
    ))
}

/// Writes paths in commands of some parts each.
fn write_paths<'p>(
    out: &mut Output<'_>,
    command: &str,
    paths: impl Iterator<Item = &'p [[f32; 2]]>,
    is_closed: bool,
    page: &Page,
) -> Result<(), Error> {
    let mut parts = 0;
    for path in paths {
        if parts == 0 {
            out.text(format_args!("{command}"))?;
        }
        out.text(format_args!("\n"))?;
        page.path(out, path, is_closed)?;
        // A path of many places counts as many.
        parts += path.len().div_ceil(3);
        if parts >= PARTS {
            out.text(format_args!(";\n"))?;
            parts = 0;
        }
    }
    match parts {
        0 => Ok(()),
        _ => out.text(format_args!(";\n")),
    }
}

/// Fills the triangles, those of one colour together; a thin line of the same colour closes the seams.
fn write_triangles(out: &mut Output<'_>, scene: &Scene<'_>, page: &Page) -> Result<(), Error> {
    let colors = scene.colors();
    let mut of_class = vec![Vec::new(); colors.len()];
    scene.each_triangle(|corners, class| of_class[class].push(corners))?;
    for (class, triangles) in of_class.iter().enumerate() {
        if triangles.is_empty() {
            continue;
        }
        let name = format!("fill {class}");
        define(out, &name, colors[class])?;
        let command = format!("\\filldraw[delone {name},line width=0.1pt]");
        let paths = triangles.iter().map(|corners| &corners[..]);
        write_paths(out, &command, paths, true, page)?;
    }
    Ok(())
}

/// Draws the borders of regions, clipped to their inner sides.
fn write_bands(out: &mut Output<'_>, scene: &Scene<'_>, page: &Page) -> Result<(), Error> {
    for (i, band) in scene.bands()?.iter().enumerate() {
        if band.loops.is_empty() {
            continue;
        }
        let name = format!("region {i}");
        define(out, &name, band.color)?;
        let width = Page::points(2.0 * BAND_WIDTH * scene.unit);
        out.text(format_args!("\\begin{{scope}}\n\\clip"))?;
        for path in &band.loops {
            out.text(format_args!("\n"))?;
            page.path(out, path, true)?;
        }
        out.text(format_args!(";\n"))?;
        let command =
            format!("\\draw[delone {name},opacity={BAND_OPACITY},line width={width:.2}pt]");
        let paths = band.loops.iter().map(|path| &path[..]);
        write_paths(out, &command, paths, true, page)?;
        out.text(format_args!("\\end{{scope}}\n"))?;
    }
    Ok(())
}

fn write_lines(
    out: &mut Output<'_>,
    class: &EdgeClass,
    color: &str,
    page: &Page,
) -> Result<(), Error> {
    let (width, opacity) = (Page::points(class.width), class.opacity);
    let command = format!("\\draw[delone {color},opacity={opacity:.2},line width={width:.2}pt]");
    let paths = class.edges.iter().map(|ends| &ends[..]);
    write_paths(out, &command, paths, false, page)
}

fn write_dots(
    out: &mut Output<'_>,
    places: impl Iterator<Item = [f32; 2]>,
    radius: f32,
    color: &str,
    page: &Page,
) -> Result<(), Error> {
    let radius = Page::points(radius);
    let places: Vec<_> = places.collect();
    for some in places.chunks(PARTS) {
        out.text(format_args!("\\fill[delone {color}]"))?;
        for &place in some {
            out.text(format_args!("\n"))?;
            page.place(out, place)?;
            out.text(format_args!(" circle[radius={radius:.2}pt]"))?;
        }
        out.text(format_args!(";\n"))?;
    }
    Ok(())
}
