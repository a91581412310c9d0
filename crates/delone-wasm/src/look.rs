//! What lies at a place: the triangle, the nearest vertex, and the cells of all vertices; for players and meshes.
//!
//! A [`Looker`] knows points and triangles and nothing else, so it serves any step of any algorithm: triangles need
//! not cover a convex hull, nor be Delaunay. Every answer is exact; lengths and cells are rounded.
//!
//! *Cost*: O(n log n) to make: in a browser, some 15 ms for 20,000 points and their triangles. A question takes in
//! practice O(log n) (`boxes.rs`), a walk one or two signs a triangle (`walk.rs`), and cells some 2 µs a point
//! (`cells.rs`).

mod boxes;
mod cells;
mod walk;

use crate::{Trouble, json};
use boxes::{Bounds, Boxes};
use delone::predicates::{Orientation, compare_distances, orient2d};
use delone::{Point, VertexId};
use serde::Serialize;
use walk::Ways;
use wasm_bindgen::prelude::wasm_bindgen;

/// Finds what lies at a place of a scene, or a mesh, as it was when this was made.
#[wasm_bindgen]
pub struct Looker {
    points: Vec<Point>,
    triangles: Vec<[Point; 3]>,
    of_points: Boxes,
    of_triangles: Boxes,
    ways: Ways,
}

/// The vertex nearest to a place, and a way to there.
#[derive(Serialize)]
struct Nearest {
    vertex: u32,
    distance: f64,
    walk: Vec<u32>,
}

impl Looker {
    /// Prepares to look at triangles, counter-clockwise, between points; answers number both as they come.
    pub(crate) fn of(
        points: impl IntoIterator<Item = Point>,
        triangles: impl IntoIterator<Item = [VertexId; 3]>,
    ) -> Self {
        let points: Vec<_> = points.into_iter().collect();
        let corners: Vec<_> = triangles.into_iter().collect();
        let places = |[a, b, c]: [VertexId; 3]| {
            let place = |v: VertexId| points.get(v.index()).copied();
            Some([place(a)?, place(b)?, place(c)?])
        };
        // A triangle of which a corner is missing, as a broken log may have it, is flat: nothing is in it.
        let triangles = corners.iter().map(|&t| places(t).unwrap_or_default());
        let triangles: Vec<_> = triangles.collect();
        Self {
            of_points: Boxes::of(points.len(), |i| Bounds::around(&[points[i]])),
            of_triangles: Boxes::of(triangles.len(), |i| Bounds::around(&triangles[i])),
            ways: Ways::of(points.len(), corners),
            points,
            triangles,
        }
    }

    /// Finds the triangle in which a place lies, or on its border; of several the first.
    fn find_triangle(&self, p: Point) -> Option<u32> {
        let mut found = None;
        let boxes = &self.of_triangles;
        let mut nodes: Vec<_> = boxes.root().into_iter().collect();
        while let Some(node) = nodes.pop() {
            if !boxes.bounds(node).holds(p) {
                continue;
            }
            match boxes.halves(node) {
                Some(halves) => nodes.extend(halves),
                None => {
                    let items = boxes.items(node).iter().copied();
                    let holding = items.filter(|&t| holds(self.triangles[t as usize], p));
                    found = found.into_iter().chain(holding).min();
                }
            }
        }
        found
    }

    /// Finds the vertex that is nearest to a place; of several the first.
    ///
    /// What cannot be nearer than the best so far is passed over: the point of a box that is nearest is exact.
    fn find_vertex(&self, p: Point) -> Option<u32> {
        let mut best = None;
        let boxes = &self.of_points;
        let mut nodes: Vec<_> = boxes.root().into_iter().collect();
        while let Some(node) = nodes.pop() {
            let is_farther = |best: u32| {
                let nearest = boxes.bounds(node).nearest(p);
                compare_distances(p, nearest, self.points[best as usize]).is_gt()
            };
            if best.is_some_and(is_farther) {
                continue;
            }
            match boxes.halves(node) {
                Some(mut halves) => {
                    let [a, b] = halves.map(|half| boxes.bounds(half).nearest(p));
                    if compare_distances(p, a, b).is_le() {
                        halves.reverse();
                    }
                    nodes.extend(halves);
                }
                None => {
                    let items = boxes.items(node).iter().copied();
                    best = best.into_iter().chain(items).min_by(|&v, &w| {
                        let [a, b] = [v, w].map(|v| self.points[v as usize]);
                        compare_distances(p, a, b).then(v.cmp(&w))
                    });
                }
            }
        }
        best
    }
}

#[wasm_bindgen]
impl Looker {
    /// Finds the triangle at a place, by its number; on an edge or a vertex, the first there; `undefined` outside.
    #[wasm_bindgen(js_name = triangleAt)]
    pub fn triangle_at(&self, x: f64, y: f64) -> Result<Option<u32>, Trouble> {
        Ok(self.find_triangle(place(x, y)?))
    }

    /// Finds the vertex that is nearest to a place, the first of several, as JSON: `{vertex, distance, walk}`;
    /// `null` if there is none. `walk` are the triangles, by number, through which a straight walk comes to the
    /// place from the first triangle (or the next that is not too thin); it ends sooner where the triangles end.
    pub fn nearest(&self, x: f64, y: f64) -> Result<String, Trouble> {
        let p = place(x, y)?;
        let found = self.find_vertex(p).map(|vertex| {
            let at = self.points[vertex as usize];
            Nearest {
                vertex,
                distance: (p.x - at.x).hypot(p.y - at.y),
                walk: self.ways.walk(&self.triangles, p),
            }
        });
        Ok(json::write(&found))
    }

    /// Returns the borders of the Voronoi cells of all points, as segments (x0, y0, x1, y1, …), clipped to a box:
    /// that between two corners (x0, y0, x1, y1), or one with a tenth of room around the points.
    ///
    /// The cells are those of the points, whatever triangles there are.
    pub fn cells(&self, clip: Option<Vec<f64>>) -> Result<Vec<f64>, Trouble> {
        cells::borders(&self.points, clip.as_deref())
    }
}

/// Makes a place of coordinates.
///
/// # Errors
/// If they are not finite.
fn place(x: f64, y: f64) -> Result<Point, Trouble> {
    let p = Point::new(x, y);
    match p.is_finite() {
        true => Ok(p),
        false => Err(Trouble::asked(format!(
            "({x}, {y}) is no place: coordinates must be finite"
        ))),
    }
}

/// Tells whether a place lies in a triangle or on its border, whichever way it turns; nothing lies in a flat one.
fn holds([a, b, c]: [Point; 3], p: Point) -> bool {
    let wrong = orient2d(a, b, c).reversed();
    let sides = [[a, b], [b, c], [c, a]];
    wrong != Orientation::Collinear && sides.iter().all(|&[a, b]| orient2d(a, b, p) != wrong)
}

#[cfg(test)]
mod tests;
