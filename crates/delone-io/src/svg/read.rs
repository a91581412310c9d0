//! Reading the paths of a picture.
//!
//! After SVG 1.1 and 2 (W3C). Read are path, line, polyline, polygon, rect, circle and ellipse, wherever they
//! are: in groups with transforms, in pictures within the picture, and where `use` shows them. Whatever else is
//! drawn is named in a note; what `display="none"` hides is not read.
//!
//! - Coordinates are those of the user space of the outermost picture, whatever its `viewBox` makes of them on
//!   the screen. There y points down: it is **negated**, so that pictures stand upright.
//! - Each element is a feature, numbered from 1 as a marker. Its closed subpaths are the rings of one polygon,
//!   by the rule even–odd; open ones are lines, and those of one point are points. Neither fill nor stroke
//!   matters, nor clip paths and masks, which is noted.
//! - Shapes whose size is given in per cent are backgrounds and left out, with a note.
//!
//! So the pictures that this crate writes come back as the triangles that they show, to the tenth of a pixel,
//! and the glyphs of their legends; nobody should use them to keep a mesh.

use super::basic::{self, Basic};
use super::transform::{self, Length};
use super::tree::{self, Element, MAX_DEPTH, Stop, Tree};
use crate::curve::{self, Affine, Outline, Place3};
use crate::shapes::{Position, Shapes};
use crate::{DomainData, Error, Place, Problem, ReadOptions, cancel, scan, words};
use delone::{Point, Watch};
use std::collections::BTreeMap;

/// Most elements that are drawn by `use`.
const MAX_COPIES: usize = 1 << 20;

/// Elements that draw nothing where they stand.
const SILENT: [&[u8]; 17] = [
    b"defs",
    b"symbol",
    b"clipPath",
    b"mask",
    b"marker",
    b"pattern",
    b"linearGradient",
    b"radialGradient",
    b"filter",
    b"metadata",
    b"title",
    b"desc",
    b"style",
    b"script",
    b"view",
    b"animate",
    b"set",
];

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let head = scan::without_mark(head).trim_ascii_start();
    let has = |text: &[u8]| memchr::memmem::find(head, text).is_some();
    head.starts_with(b"<") && (has(b"<svg") || has(b"<!DOCTYPE svg")) && !has(b"<html")
}

/// Reads a domain.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let malformed = |stop| match stop {
        Stop::Cancelled => Error::Cancelled,
        Stop::Wrong(at, problem) => Error::Malformed {
            file: file.to_owned(),
            place: Place::in_text(bytes, at),
            problem,
        },
    };
    if bytes.trim_ascii().is_empty() {
        return Err(Error::Malformed {
            file: file.to_owned(),
            place: Place::File,
            problem: Problem::Empty,
        });
    }
    let tree = tree::read(bytes, watch).map_err(malformed)?;
    let mut walk = Walk {
        tree: &tree,
        flatness: options.flatness,
        watch,
        shapes: Shapes::default(),
        left_out: BTreeMap::new(),
        cuts: 0,
        round: 0,
        copies: 0,
        made: 0,
    };
    let upright = Affine::scale([1.0, -1.0, 1.0]);
    let root = &tree.elements[0];
    walk.children(root, &upright, Inside::default())
        .map_err(malformed)?;
    Ok(walk.finish())
}

/// What an element is in.
#[derive(Clone, Copy, Default)]
struct Inside {
    depth: usize,
    /// Whether a `use` shows it.
    is_copy: bool,
}

struct Walk<'t> {
    tree: &'t Tree,
    flatness: Option<f64>,
    watch: &'t dyn Watch,
    shapes: Shapes,
    /// Elements that are not read, and how many there are.
    left_out: BTreeMap<String, usize>,
    /// Elements that a clip path or mask should cut.
    cuts: usize,
    round: usize,
    copies: usize,
    /// Points that the file does not have: of curves, and by `use`.
    made: usize,
}

impl<'t> Walk<'t> {
    fn children(&mut self, parent: &'t Element, map: &Affine, inside: Inside) -> Result<(), Stop> {
        for &child in &parent.children {
            self.element(&self.tree.elements[child], map, inside)?;
        }
        Ok(())
    }

    fn element(&mut self, element: &'t Element, map: &Affine, inside: Inside) -> Result<(), Stop> {
        self.round += 1;
        cancel::check(self.watch, self.round).map_err(|_| Stop::Cancelled)?;
        let wrong = |problem| Stop::Wrong(element.at, problem);
        let inside = Inside {
            depth: inside.depth + 1,
            ..inside
        };
        if inside.depth > MAX_DEPTH {
            let text = format!(
                "elements and uses in one another, deeper than {MAX_DEPTH}, or without end"
            );
            return Err(wrong(Problem::Other(text)));
        }
        self.copies += usize::from(inside.is_copy);
        if self.copies > MAX_COPIES || self.made > curve::MAX_POINTS {
            let text = "the picture is too large; use fewer copies, or a larger --flatness";
            return Err(wrong(Problem::Other(text.to_owned())));
        }
        if element.is_hidden() || SILENT.contains(&&element.name[..]) {
            return Ok(());
        }
        self.cuts +=
            usize::from(element.get("clip-path").is_some() || element.get("mask").is_some());
        let own = transform::parse(element.get("transform").unwrap_or_default()).map_err(wrong)?;
        let map = map.after(&own);
        match &element.name[..] {
            b"g" | b"a" | b"switch" => self.children(element, &map, inside),
            b"svg" => self.picture(element, &map, inside),
            b"use" => self.copy(element, &map, inside),
            _ => match basic::draw(element).map_err(wrong)? {
                Some(Basic::Outlines(outlines)) => self.add(&outlines, &map, inside).map_err(wrong),
                Some(Basic::Background) => {
                    let name = String::from_utf8_lossy(&element.name);
                    self.leave_out(format!("{name} with lengths in per cent"));
                    Ok(())
                }
                None => {
                    // Elements of other vocabularies draw nothing.
                    if !element.name.contains(&b':') {
                        self.leave_out(String::from_utf8_lossy(&element.name).into_owned());
                    }
                    Ok(())
                }
            },
        }
    }

    /// Draws a picture within the picture.
    fn picture(&mut self, element: &'t Element, map: &Affine, inside: Inside) -> Result<(), Stop> {
        let view = view(element).map_err(|problem| Stop::Wrong(element.at, problem))?;
        self.children(element, &map.after(&view), inside)
    }

    /// Draws what a `use` shows.
    fn copy(&mut self, element: &'t Element, map: &Affine, inside: Inside) -> Result<(), Stop> {
        let link = element.get("href").or_else(|| element.get("xlink:href"));
        let id = link.and_then(|link| link.trim_ascii().strip_prefix(b"#"));
        let Some(&shown) = id.and_then(|id| self.tree.ids.get(id)) else {
            self.leave_out("use of something that is not in the file".to_owned());
            return Ok(());
        };
        let place = place(element).map_err(|problem| Stop::Wrong(element.at, problem))?;
        let map = map.after(&place);
        let inside = Inside {
            is_copy: true,
            ..inside
        };
        let shown = &self.tree.elements[shown];
        match &shown.name[..] {
            b"symbol" if !shown.is_hidden() => {
                let size = Frame::of(element)
                    .map_err(|p| Stop::Wrong(element.at, p))?
                    .size;
                let view = scaled(shown, size).map_err(|p| Stop::Wrong(shown.at, p))?;
                self.children(shown, &map.after(&view), inside)
            }
            _ => self.element(shown, &map, inside),
        }
    }

    /// Adds what an element draws.
    fn add(&mut self, outlines: &[Outline], map: &Affine, inside: Inside) -> Result<(), Problem> {
        let mut rings = Vec::new();
        for outline in outlines {
            let line = outline.mapped(map).flatten(self.flatness)?;
            let in_file = if inside.is_copy {
                0
            } else {
                outline.pieces.len() + 1
            };
            self.made += line.len().saturating_sub(in_file);
            let line: Vec<_> = line.into_iter().map(position).collect();
            match &line[..] {
                [_] => self.shapes.point(line[0])?,
                [a, b] if a.point == b.point => self.shapes.point(*a)?,
                [first, _, _, .., last] if first.point == last.point => rings.push(line),
                line => self.shapes.line(line)?,
            }
        }
        self.shapes.polygon(rings.iter().map(Vec::as_slice))?;
        self.shapes.end_feature(None);
        Ok(())
    }

    fn leave_out(&mut self, what: String) {
        // Names come from the file.
        let known = self.left_out.len() < 40 || self.left_out.contains_key(&what);
        let what = if known { what } else { "others".to_owned() };
        *self.left_out.entry(what).or_default() += 1;
    }

    fn finish(self) -> DomainData {
        let mut domain = self.shapes.finish();
        let notes = &mut domain.vertices.notes;
        if !self.left_out.is_empty() {
            let counts = self.left_out.iter().map(|(what, n)| format!("{n} {what}"));
            notes.push(format!(
                "left out: {}",
                words::list(&counts.collect::<Vec<_>>())
            ));
        }
        if self.cuts > 0 {
            let shapes = words::counted(self.cuts, "element is", "elements are");
            notes.push(format!(
                "{shapes} read whole, as clip paths and masks cut nothing"
            ));
        }
        domain
    }
}

fn position([x, y, _]: Place3) -> Position {
    Position {
        // Negated zeros are none.
        point: Point::new(x + 0.0, y + 0.0),
        extras: [f64::NAN; 2],
    }
}

/// Where a view is, and how large, if that is said in units.
struct Frame {
    place: [f64; 2],
    size: [Option<f64>; 2],
}

impl Frame {
    fn of(element: &Element) -> Result<Self, Problem> {
        let length = |name| match element.get(name).map(transform::length).transpose()? {
            Some(Length::Units(value)) => Ok(Some(value)),
            _ => Ok(None),
        };
        Ok(Self {
            place: [length("x")?.unwrap_or(0.0), length("y")?.unwrap_or(0.0)],
            size: [length("width")?, length("height")?],
        })
    }
}

/// Returns the shift to where an element is placed.
fn place(element: &Element) -> Result<Affine, Problem> {
    let [x, y] = Frame::of(element)?.place;
    Ok(Affine::shift([x, y, 0.0]))
}

/// Returns the map into a picture within the picture.
fn view(element: &Element) -> Result<Affine, Problem> {
    let size = Frame::of(element)?.size;
    Ok(place(element)?.after(&scaled(element, size)?))
}

/// Returns the map from what an element's `viewBox` shows to a view of this size.
fn scaled(element: &Element, size: [Option<f64>; 2]) -> Result<Affine, Problem> {
    match element.get("viewBox") {
        None => Ok(Affine::IDENTITY),
        Some(text) => {
            let ratio = element.get("preserveAspectRatio").unwrap_or_default();
            transform::view_box(text, size, ratio)
        }
    }
}
