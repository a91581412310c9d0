//! GeoJSON and well-known text: nested lists of positions.

use super::tables::{add_ring, close_polygon, fields, first_two};
use delone::{Point, Pslg};
use serde_json::Value;

/// Reads GeoJSON, an array of positions, or an array of the rings of one polygon.
pub(super) fn json(text: &str) -> Pslg {
    let mut pslg = Pslg::default();
    let value: Value = serde_json::from_str(text).expect("JSON");
    match depth(&value) {
        0 => add_object(&mut pslg, &value),
        2 => add_points(&mut pslg, &value),
        _ => add_polygon(&mut pslg, &value),
    }
    pslg
}

/// Counts the arrays around the first number.
fn depth(value: &Value) -> usize {
    let first = value.as_array().and_then(|items| items.first());
    first.map_or(0, |item| 1 + depth(item))
}

fn add_object(pslg: &mut Pslg, value: &Value) {
    for member in ["features", "geometries"] {
        items(&value[member]).for_each(|item| add_object(pslg, item));
    }
    if value["geometry"].is_object() {
        add_object(pslg, &value["geometry"]);
    }
    let coordinates = &value["coordinates"];
    let all = items(coordinates);
    match value["type"].as_str() {
        Some("Point" | "MultiPoint") => add_points(pslg, coordinates),
        Some("LineString") => add_line(pslg, &positions(coordinates)),
        Some("MultiLineString") => all.for_each(|line| add_line(pslg, &positions(line))),
        Some("Polygon") => add_polygon(pslg, coordinates),
        Some("MultiPolygon") => all.for_each(|polygon| add_polygon(pslg, polygon)),
        _ => {}
    }
}

fn add_points(pslg: &mut Pslg, value: &Value) {
    match position(value) {
        Some(p) => pslg.points.push(p),
        None => pslg.points.extend(positions(value)),
    }
}

fn add_line(pslg: &mut Pslg, line: &[Point]) {
    let first = pslg.points.len();
    pslg.points.extend(line);
    pslg.add_polyline(first as u32..pslg.points.len() as u32);
}

fn add_polygon(pslg: &mut Pslg, rings: &Value) {
    let first = pslg.segments.len();
    items(rings).for_each(|ring| add_ring(pslg, &positions(ring)));
    close_polygon(pslg, first);
}

fn positions(value: &Value) -> Vec<Point> {
    items(value).filter_map(position).collect()
}

fn position(value: &Value) -> Option<Point> {
    let [x, y] = value.as_array()?.first_chunk()?;
    Some(Point::new(x.as_f64()?, y.as_f64()?))
}

fn items(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

/// Reads well-known text: the word before a list tells what it is.
pub(super) fn wkt(text: &str) -> Pslg {
    let mut pslg = Pslg::default();
    let mut shape = Shape::Points;
    let (mut depth, mut polygon) = (0, 0);
    let mut rest = text;
    while let Some(at) = rest.find(['(', ')']) {
        let before = &rest[..at];
        if rest[at..].starts_with('(') {
            shape = Shape::named(before).unwrap_or(shape);
            depth += 1;
        } else {
            add_list(&mut pslg, shape, before);
            depth -= 1;
            if shape == Shape::Polygon(depth) {
                close_polygon(&mut pslg, polygon);
                polygon = pslg.segments.len();
            }
        }
        rest = &rest[at + 1..];
    }
    pslg
}

/// What the innermost lists are.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Points,
    Lines,
    /// Rings; a polygon ends where so many lists are still open.
    Polygon(usize),
}

impl Shape {
    fn named(text: &str) -> Option<Self> {
        let is_name = |word: &&str| word.len() > 2 && word.chars().all(char::is_uppercase);
        let name = text.split_whitespace().rfind(is_name)?;
        Some(match name {
            "POINT" | "MULTIPOINT" => Self::Points,
            "LINESTRING" | "MULTILINESTRING" => Self::Lines,
            "POLYGON" => Self::Polygon(0),
            "MULTIPOLYGON" => Self::Polygon(1),
            _ => panic!("what is a {name}?"),
        })
    }
}

fn add_list(pslg: &mut Pslg, shape: Shape, text: &str) {
    let row_of = |text| first_two(&fields(text));
    let list: Vec<_> = text.split(',').filter_map(row_of).collect();
    match shape {
        Shape::Points => pslg.points.extend(list),
        Shape::Lines => add_line(pslg, &list),
        Shape::Polygon(_) => add_ring(pslg, &list),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLES: &str = "((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1))";

    /// Numbers of points and segments, and the segments of each polygon.
    fn sizes(pslg: &Pslg) -> (usize, usize, Vec<[usize; 2]>) {
        let polygons = pslg.polygons.iter().map(|range| [range.start, range.end]);
        (pslg.points.len(), pslg.segments.len(), polygons.collect())
    }

    #[test]
    fn polygons_keep_their_holes_together() {
        let one = wkt(&format!("POLYGON {TRIANGLES}"));
        assert_eq!(sizes(&one), (8, 6, vec![[0, 6]]));
        let two = wkt(&format!("MULTIPOLYGON({TRIANGLES},\n {TRIANGLES})"));
        assert_eq!(sizes(&two), (16, 12, vec![[0, 6], [6, 12]]));
        let rings = r#"[[[0,0],[4,0],[0,4],[0,0]],[[1,1],[2,1],[1,2],[1,1]]]"#;
        assert_eq!(sizes(&json(rings)), sizes(&one));
        let multi = format!(r#"{{"type": "MultiPolygon", "coordinates": [{rings},{rings}]}}"#);
        assert_eq!(sizes(&json(&multi)), sizes(&two));
    }
}
