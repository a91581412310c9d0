//! Entities as outlines in their own coordinates, and the maps from these to the drawing.

use super::codes::Group;
use super::drawing::{Entity, LAYER};
use crate::Problem;
use crate::curve::{Affine, Arc, Outline, Place3, Spline, unit};
use std::f64::consts::TAU;

/// Parameters of ellipses that differ by a whole turn but for this are those of a whole one.
const NEARLY: f64 = 1e-9;

/// What an entity draws.
pub(super) enum Drawn {
    Point(Place3),
    Curve(Outline),
    /// The border of a face.
    Face(Outline),
    /// Nothing that can be read, and what it is called.
    Unread(&'static str),
}

/// The groups of an entity, asked by code.
#[derive(Clone, Copy)]
pub(super) struct Fields<'g, 'a> {
    pub groups: &'g [Group<'a>],
    /// Where the entity begins.
    pub at: u64,
}

/// A problem and where it stands.
pub(super) type Wrong = (u64, Problem);

impl<'g, 'a> Fields<'g, 'a> {
    pub fn new(entity: &Entity<'a>, groups: &'g [Group<'a>]) -> Self {
        Self {
            groups: &groups[entity.groups.clone()],
            at: entity.at,
        }
    }

    /// Returns the layer.
    pub fn layer(&self) -> &'a [u8] {
        let group = self.groups.iter().find(|group| group.code == LAYER);
        group.map_or(b"0", |group| group.text())
    }

    /// Returns the text of a group.
    pub fn text(&self, code: i32) -> &'a [u8] {
        let group = self.groups.iter().find(|group| group.code == code);
        group.map_or(b"", |group| group.text())
    }

    /// Returns a number, if the entity has it.
    pub fn given(&self, code: i32) -> Result<Option<f64>, Wrong> {
        let group = self.groups.iter().find(|group| group.code == code);
        group.map(value).transpose()
    }

    /// Returns a number, or what it usually is.
    pub fn number(&self, code: i32, usual: f64) -> Result<f64, Wrong> {
        Ok(self.given(code)?.unwrap_or(usual))
    }

    /// Returns a number that must be there.
    fn required(&self, code: i32, what: &str) -> Result<f64, Wrong> {
        let missing = || {
            let text = format!("group {code}, {what}, is missing");
            (self.at, Problem::Other(text))
        };
        self.given(code)?.ok_or_else(missing)
    }

    /// Returns a place, of groups `code`, `code + 10` and `code + 20`.
    pub fn place(&self, code: i32) -> Result<Place3, Wrong> {
        Ok([
            self.required(code, "x")?,
            self.required(code + 10, "y")?,
            self.number(code + 20, 0.0)?,
        ])
    }

    /// Tells whether a flag of group 70 is set.
    fn flag(&self, flag: i64) -> Result<bool, Wrong> {
        Ok(self.number(70, 0.0)? as i64 & flag != 0)
    }

    /// Tells whether the entity lies on a sheet of paper and not in the drawing.
    pub fn is_on_paper(&self) -> Result<bool, Wrong> {
        Ok(self.number(67, 0.0)? == 1.0)
    }

    /// Returns the map from the entity's own coordinates, if it has such, by the direction of its extrusion:
    /// the *arbitrary axis algorithm* of the specification.
    pub fn own_axes(&self) -> Result<Affine, Wrong> {
        let direction = [
            self.number(210, 0.0)?,
            self.number(220, 0.0)?,
            self.number(230, 1.0)?,
        ];
        let Some(z) = normalized(direction) else {
            return Ok(Affine::IDENTITY);
        };
        let is_near_z = z[0].abs() < 1.0 / 64.0 && z[1].abs() < 1.0 / 64.0;
        let other = if is_near_z {
            [0.0, 1.0, 0.0]
        } else {
            [0.0, 0.0, 1.0]
        };
        let x = normalized(cross(other, z)).unwrap_or([1.0, 0.0, 0.0]);
        Ok(Affine {
            axes: [x, cross(z, x), z],
            origin: [0.0; 3],
        })
    }

    /// Returns the map from a block's coordinates to those around one of the insertion's copies.
    pub fn insertion(&self, base: Place3, [column, row]: [f64; 2]) -> Result<Affine, Wrong> {
        let scale = [
            self.number(41, 1.0)?,
            self.number(42, 1.0)?,
            self.number(43, 1.0)?,
        ];
        let apart = [
            column * self.number(44, 0.0)?,
            row * self.number(45, 0.0)?,
            0.0,
        ];
        let maps = [
            Affine::shift(self.place(10)?),
            Affine::turn(self.number(50, 0.0)?),
            Affine::shift(apart),
            Affine::scale(scale),
            Affine::shift(base.map(|value| -value)),
        ];
        let all = maps
            .iter()
            .fold(self.own_axes()?, |all, map| all.after(map));
        Ok(all)
    }

    /// Returns the numbers of columns and rows of an insertion.
    pub fn copies(&self) -> Result<[u64; 2], Wrong> {
        // As casts do it: nothing below zero, and no overflow.
        Ok([self.number(70, 1.0)? as u64, self.number(71, 1.0)? as u64].map(|n| n.max(1)))
    }
}

fn value(group: &Group<'_>) -> Result<f64, Wrong> {
    group.number().map_err(|problem| (group.at, problem))
}

fn cross([a, b, c]: Place3, [d, e, f]: Place3) -> Place3 {
    // Positive zeros only, as negative ones would be written.
    [b * f - c * e, c * d - a * f, a * e - b * d].map(|value| value + 0.0)
}

fn normalized(vector: Place3) -> Option<Place3> {
    let largest = vector.into_iter().map(f64::abs).fold(0.0, f64::max);
    if largest == 0.0 {
        return None;
    }
    let vector = vector.map(|value| value / largest);
    let length = vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    Some(vector.map(|value| value / length))
}

/// Makes what an entity draws, in the coordinates of what it is in; polylines with vertices of their own are
/// made by [`polyline`].
pub(super) fn draw(entity: &Entity<'_>, fields: Fields<'_, '_>) -> Result<Drawn, Wrong> {
    if entity.is("POINT") {
        Ok(Drawn::Point(fields.place(10)?))
    } else if entity.is("LINE") {
        let mut outline = Outline::new(fields.place(10)?);
        outline.line(fields.place(11)?);
        Ok(Drawn::Curve(outline))
    } else if entity.is("LWPOLYLINE") {
        light(fields)
    } else if entity.is("CIRCLE") || entity.is("ARC") {
        let degrees = entity.is("ARC").then_some([50, 51]);
        circle(fields, degrees).map(Drawn::Curve)
    } else if entity.is("ELLIPSE") {
        ellipse(fields).map(Drawn::Curve)
    } else if entity.is("SPLINE") {
        spline(fields)
    } else {
        // Corners of a face go around, those of a solid to and fro.
        let (order, is_solid) = match entity.is("3DFACE") {
            true => ([10, 11, 12, 13], false),
            false => ([10, 11, 13, 12], true),
        };
        face(fields, order, is_solid).map(Drawn::Face)
    }
}

/// Makes the outline of a polyline of light weight, whose vertices are in its own groups.
fn light(fields: Fields<'_, '_>) -> Result<Drawn, Wrong> {
    let z = fields.number(38, 0.0)?;
    let mut vertices: Vec<(Place3, f64)> = Vec::new();
    for group in fields.groups {
        match group.code {
            10 => vertices.push(([value(group)?, f64::NAN, z], 0.0)),
            20 | 42 => {
                let Some((place, bulge)) = vertices.last_mut() else {
                    let text = format!("group {} of a vertex before its x, group 10", group.code);
                    return Err((group.at, Problem::Other(text)));
                };
                *(if group.code == 20 {
                    &mut place[1]
                } else {
                    bulge
                }) = value(group)?;
            }
            _ => {}
        }
    }
    if let Some(i) = vertices.iter().position(|(place, _)| place[1].is_nan()) {
        let text = format!("vertex {} of the polyline has no y, group 20", i + 1);
        return Err((fields.at, Problem::Other(text)));
    }
    let axes = fields.own_axes()?;
    Ok(chain(&vertices, fields.flag(1)?)
        .map_or(Drawn::Unread("LWPOLYLINE without vertices"), |c| {
            Drawn::Curve(c.mapped(&axes))
        }))
}

/// Makes what a polyline and its vertices draw.
pub(super) fn polyline(
    fields: Fields<'_, '_>,
    vertices: &[Fields<'_, '_>],
) -> Result<Drawn, Wrong> {
    const MESHES: i64 = 16 | 64;
    /// Control points of a spline, which is there as lines, too.
    const FRAME: i64 = 16;
    const IN_SPACE: i64 = 8;
    if fields.flag(MESHES)? {
        return Ok(Drawn::Unread("POLYLINE that is a mesh"));
    }
    let is_flat = !fields.flag(IN_SPACE)?;
    let z = fields.number(30, 0.0)?;
    let mut places = Vec::new();
    for vertex in vertices {
        if vertex.flag(FRAME)? {
            continue;
        }
        let mut place = vertex.place(10)?;
        if is_flat {
            place[2] = z;
        }
        let bulge = if is_flat {
            vertex.number(42, 0.0)?
        } else {
            0.0
        };
        places.push((place, bulge));
    }
    let axes = match is_flat {
        true => fields.own_axes()?,
        false => Affine::IDENTITY,
    };
    Ok(
        chain(&places, fields.flag(1)?).map_or(Drawn::Unread("POLYLINE without vertices"), |c| {
            Drawn::Curve(c.mapped(&axes))
        }),
    )
}

/// Joins vertices by lines, and by arcs where they have a bulge.
fn chain(vertices: &[(Place3, f64)], is_closed: bool) -> Option<Outline> {
    let &(start, _) = vertices.first()?;
    let mut outline = Outline::new(start);
    let next = vertices.iter().skip(1).map(|&(place, _)| place);
    let back = is_closed.then_some(start);
    for (&(from, bulge), to) in vertices.iter().zip(next.chain(back)) {
        match Arc::bulge([from, to], bulge) {
            Some(arc) => outline.arc(arc, to),
            // The last vertex may be the first once more.
            None if from == to => {}
            None => outline.line(to),
        }
    }
    outline.is_closed = is_closed;
    Some(outline)
}

/// Makes a circle, or of it the arc between two angles.
fn circle(fields: Fields<'_, '_>, degrees: Option<[i32; 2]>) -> Result<Outline, Wrong> {
    let center = fields.place(10)?;
    let radius = fields.required(40, "the radius")?.abs();
    let axes = fields.own_axes()?;
    let mut arc = Arc::whole(center, [radius, 0.0, 0.0], [0.0, radius, 0.0]);
    let [mut first, mut last] = [0.0; 2];
    if let Some([from, to]) = degrees {
        first = fields.required(from, "where the arc begins")?;
        last = fields.required(to, "where the arc ends")?;
    }
    let sweep = (last - first).rem_euclid(360.0);
    let start = arc.toward(unit(first));
    let mut outline = Outline::new(start);
    if sweep == 0.0 {
        outline.is_closed = true;
        if degrees.is_some() {
            arc.start = first.rem_euclid(360.0).to_radians();
        }
        outline.arc(arc, start);
    } else {
        arc.start = first.rem_euclid(360.0).to_radians();
        arc.sweep = sweep.to_radians();
        let end = arc.toward(unit(last));
        outline.arc(arc, end);
    }
    Ok(outline.mapped(&axes))
}

/// Makes an ellipse, or an arc of it; both axes are given in the coordinates around it.
fn ellipse(fields: Fields<'_, '_>) -> Result<Outline, Wrong> {
    let center = fields.place(10)?;
    let u = fields.place(11)?;
    let ratio = fields.required(40, "the ratio of the axes")?;
    let z = normalized([
        fields.number(210, 0.0)?,
        fields.number(220, 0.0)?,
        fields.number(230, 1.0)?,
    ]);
    let v = cross(z.unwrap_or([0.0, 0.0, 1.0]), u).map(|value| value * ratio);
    let [first, last] = [fields.number(41, 0.0)?, fields.number(42, TAU)?];
    let mut arc = Arc::whole(center, u, v);
    let sweep = (last - first).rem_euclid(TAU);
    if sweep < NEARLY || TAU - sweep < NEARLY {
        let mut outline = Outline::new(arc.toward([1.0, 0.0]));
        outline.arc(arc, outline.start);
        outline.is_closed = true;
        return Ok(outline);
    }
    (arc.start, arc.sweep) = (first, sweep);
    let mut outline = Outline::new(arc.at(first));
    outline.arc(arc, arc.at(last));
    Ok(outline)
}

/// Makes a spline from its knots, weights and control points.
fn spline(fields: Fields<'_, '_>) -> Result<Drawn, Wrong> {
    let mut spline = Spline {
        degree: fields.required(71, "the degree of the spline")? as usize,
        ..Spline::default()
    };
    let mut weights = Vec::new();
    for group in fields.groups {
        let number = value(group);
        match (group.code, spline.control.last_mut()) {
            (40, _) => spline.knots.push(number?),
            (41, _) => weights.push(number?),
            (10, _) => spline.control.push([number?, 0.0, 0.0, 1.0]),
            (20, Some(point)) => point[1] = number?,
            (30, Some(point)) => point[2] = number?,
            _ => {}
        }
    }
    if spline.control.is_empty() {
        return Ok(Drawn::Unread("SPLINE without control points"));
    }
    let wrong = |problem| (fields.at, problem);
    if !weights.is_empty() && weights.len() != spline.control.len() {
        let (found, expected) = (weights.len(), spline.control.len());
        let text = format!("{found} weights for {expected} control points of a spline");
        return Err(wrong(Problem::Other(text)));
    }
    for (point, weight) in spline.control.iter_mut().zip(weights) {
        point[3] = weight;
    }
    let mut outline = spline.outline().map_err(wrong)?;
    if fields.flag(1 | 2)? {
        outline.close_nearly(NEARLY);
    }
    Ok(Drawn::Curve(outline))
}

/// Makes the border of a face; a fourth corner like the third is none.
fn face(fields: Fields<'_, '_>, order: [i32; 4], is_solid: bool) -> Result<Outline, Wrong> {
    let fourth = fields.given(13)?.is_some();
    let mut outline: Option<Outline> = None;
    for code in order.into_iter().filter(|&code| code != 13 || fourth) {
        let place = fields.place(code)?;
        match &mut outline {
            Some(outline) if outline.end() == place => {}
            Some(outline) => outline.line(place),
            None => outline = Some(Outline::new(place)),
        }
    }
    let mut outline = outline.expect("bug: a face has corners");
    outline.is_closed = true;
    Ok(match is_solid {
        true => outline.mapped(&fields.own_axes()?),
        false => outline,
    })
}
