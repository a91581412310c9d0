//! The two half-edges of the edge at a place, with what is next to them: for lessons about the data structure.
//!
//! *Cost*: each edge of the scene is looked at, some ns each.

use super::Player;
use crate::look::place;
use crate::{Trouble, json};
use delone::predicates::{Orientation, orient2d};
use delone::{Point, Scene, VertexId};
use serde::Serialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// A half-edge: its origin and its dest.
type HalfEdge = [VertexId; 2];

/// An edge and its two sides.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Edge {
    edge: HalfEdge,
    is_locked: bool,
    sides: [Side; 2],
}

/// A half-edge, and its neighbours as far as there are triangles.
///
/// ```text
///          apex               next: dest → apex       onext: origin → apex
///          /  \               prev: apex → origin     oprev: origin → the twin's apex
///         /    \
///   origin ---→ dest
/// ```
#[derive(Serialize)]
struct Side {
    origin: VertexId,
    dest: VertexId,
    apex: Option<VertexId>,
    next: Option<HalfEdge>,
    prev: Option<HalfEdge>,
    onext: Option<HalfEdge>,
    oprev: Option<HalfEdge>,
}

impl Side {
    fn of([origin, dest]: HalfEdge, scene: &Scene) -> Self {
        let apex = scene.apex([origin, dest]);
        let beyond = scene.apex([dest, origin]);
        Self {
            origin,
            dest,
            apex,
            next: apex.map(|apex| [dest, apex]),
            prev: apex.map(|apex| [apex, origin]),
            onext: apex.map(|apex| [origin, apex]),
            oprev: beyond.map(|beyond| [origin, beyond]),
        }
    }
}

/// Measures how far a place is from a segment, rounded: to be pointed at, nothing else depends on it.
///
/// Lengths are divided before they are multiplied, so that neither large nor small ones are lost.
fn distance(p: Point, [a, b]: [Point; 2]) -> f64 {
    let along = [b.x - a.x, b.y - a.y];
    let scale = along[0].abs().max(along[1].abs());
    let [x, y] = along.map(|d| d / scale);
    let share = ((p.x - a.x) / scale * x + (p.y - a.y) / scale * y) / (x * x + y * y);
    // No number: the ends are one place, or the place is too far away to tell.
    let share = if share.is_nan() {
        0.0
    } else {
        share.clamp(0.0, 1.0)
    };
    let nearest = [a.x + share * along[0], a.y + share * along[1]];
    (p.x - nearest[0]).hypot(p.y - nearest[1])
}

/// Finds the edge nearest to a place: in a triangle, one of its sides; of equally near ones the first.
fn nearest(scene: &Scene, p: Point) -> Option<HalfEdge> {
    let measured = scene.edges().filter_map(|edge| {
        let [a, b] = edge.map(|v| scene.point(v));
        Some((distance(p, [a?, b?]), edge))
    });
    let nearest = measured.min_by(|(d, _), (e, _)| d.total_cmp(e));
    nearest.map(|(_, edge)| edge)
}

#[wasm_bindgen]
impl Player {
    /// Finds the edge that is nearest to a place, as JSON: `{edge: [a, b], isLocked, sides}`; `null` if there are
    /// no edges. `sides` are its half-edges, that with the place to its left first: `{origin, dest, apex, next, prev,
    /// onext, oprev}`, each of the last four `[origin, dest]` of another half-edge. `apex`, `next`, `prev` and
    /// `onext` are `null` where there is no triangle to the left, and `oprev` where there is none to the right.
    #[wasm_bindgen(js_name = halfEdgesAt)]
    pub fn half_edges_at(&self, x: f64, y: f64) -> Result<String, Trouble> {
        let (p, scene) = (place(x, y)?, self.scene());
        let found = nearest(scene, p).map(|[a, b]| {
            let ends = [a, b].map(|v| scene.point(v).unwrap_or_default());
            let is_right = orient2d(ends[0], ends[1], p) == Orientation::Right;
            let [near, far] = if is_right {
                [[b, a], [a, b]]
            } else {
                [[a, b], [b, a]]
            };
            Edge {
                edge: [a, b],
                is_locked: scene.is_locked([a, b]),
                sides: [near, far].map(|half_edge| Side::of(half_edge, scene)),
            }
        });
        Ok(json::write(&found))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use serde_json::{Value, json};

    fn player(points: &[f64]) -> Player {
        let drawing = Drawing::new(points, &[], &[]).expect("points");
        let mut player = Player::run("incremental", &drawing, None, None).expect("a run");
        player.seek(u32::MAX).expect("the end");
        player
    }

    fn at(player: &Player, x: f64, y: f64) -> Value {
        let text = player.half_edges_at(x, y).expect("a place");
        serde_json::from_str(&text).expect("JSON")
    }

    /// The square 0123 and its Delaunay diagonal 1–3.
    #[test]
    fn both_sides_of_an_edge_know_their_neighbours() {
        let player = player(&[0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0]);
        let expected = json!({
            "edge": [1, 3],
            "isLocked": false,
            "sides": [
                {"origin": 1, "dest": 3, "apex": 0, "next": [3, 0], "prev": [0, 1], "onext": [1, 0], "oprev": [1, 2]},
                {"origin": 3, "dest": 1, "apex": 2, "next": [1, 2], "prev": [2, 3], "onext": [3, 2], "oprev": [3, 0]},
            ],
        });
        assert_eq!(at(&player, 0.9, 0.9), expected);
        assert_eq!(at(&player, 1.1, 1.1)["sides"][0], expected["sides"][1]);
    }

    #[test]
    fn beyond_the_hull_there_is_nothing() {
        let player = player(&[0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0]);
        let found = at(&player, 1.0, -9.0);
        assert_eq!(found["edge"], json!([0, 1]));
        let outer = json!(
            {"origin": 1, "dest": 0, "apex": null, "next": null, "prev": null, "onext": null, "oprev": [1, 3]}
        );
        assert_eq!(found["sides"][0], outer);
    }

    #[test]
    fn the_nearest_edge_is_a_side_of_the_triangle() {
        for preset in ["uniform", "grid", "cocircular"] {
            let drawing = Drawing::preset(preset, 30, 1).expect("points");
            let mut player = Player::run("incremental", &drawing, None, None).expect("a run");
            player.seek(u32::MAX).expect("the end");
            let scene = player.scene();
            for triangle in scene.triangles() {
                let corners = triangle.map(|v| scene.point(v).expect("a corner"));
                let [x, y] = [|p: Point| p.x, |p: Point| p.y]
                    .map(|c| corners.map(c).iter().sum::<f64>() / 3.0);
                let inner = at(&player, x, y);
                let side = &inner["sides"][0];
                let named = [&side["origin"], &side["dest"], &side["apex"]].map(|v| v.as_u64());
                let mut named = named.map(|v| VertexId::new(v.expect("a vertex") as usize));
                named.sort();
                let mut triangle = triangle;
                triangle.sort();
                assert_eq!(named, triangle, "{preset}");
            }
        }
    }

    #[test]
    fn without_edges_there_is_none_and_no_place_is_refused() {
        for points in [&[][..], &[1.0, 1.0]] {
            assert_eq!(at(&player(points), 0.0, 0.0), Value::Null);
        }
        let row = player(&[0.0, 0.0, 1e-300, 1e-300, 4e-300, 4e-300]);
        assert_eq!(at(&row, 3e-300, 2e-300)["edge"], json!([1, 2]));
        assert_eq!(at(&row, 3e300, 2e300)["sides"][1]["apex"], Value::Null);
        row.half_edges_at(f64::NAN, 0.0).expect_err("no place");
    }
}
