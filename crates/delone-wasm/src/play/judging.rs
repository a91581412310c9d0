//! What is to be said of the edges and triangles of a scene: angles, circles, which edges are illegal.
//!
//! Every sign is exact. A scene may hold triangles that do not turn counter-clockwise, of a log that is replayed as
//! it was printed; nothing is said of their edges.

use super::Player;
use crate::{Trouble, json};
use delone::predicates::{CircleSide, Orientation, in_circle, in_circle_perturbed, orient2d};
use delone::{Point, Scene, VertexId, check};
use serde::Serialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// An edge, and the corners of its two triangles opposite to it: left, right.
type Quad = [VertexId; 4];

/// A circle, rounded.
#[derive(Serialize)]
struct Circle {
    center: Point,
    radius: f64,
}

/// On which side of a circle a point lies, and for which it counts.
#[derive(Serialize)]
struct Side {
    side: &'static str,
    counts: &'static str,
}

/// Visits the edges between two triangles that turn counter-clockwise, with the positions of the four.
fn quads(scene: &Scene) -> impl Iterator<Item = (Quad, [Point; 4])> + '_ {
    scene.edges().filter_map(|[a, b]| {
        let quad = [a, b, scene.apex([a, b])?, scene.apex([b, a])?];
        let [a, b, c, d] = quad.map(|v| scene.point(v));
        let [a, b, c, d] = [a?, b?, c?, d?];
        let turns =
            orient2d(a, b, c) == Orientation::Left && orient2d(b, a, d) == Orientation::Left;
        turns.then_some((quad, [a, b, c, d]))
    })
}

/// Finds the positions of vertices.
fn positions<const N: usize>(scene: &Scene, vertices: [u32; N]) -> Result<[Point; N], Trouble> {
    let mut found = [Point::default(); N];
    for (place, v) in found.iter_mut().zip(vertices) {
        let point = scene.point(VertexId::new(v as usize));
        *place = point.ok_or_else(|| {
            let vertices = scene.vertices().count();
            Trouble::asked(format!(
                "there is no vertex {v}: there are {vertices} at this step"
            ))
        })?;
    }
    Ok(found)
}

#[wasm_bindgen]
impl Player {
    /// Counts the triangles by their smallest angle: entry `d` those of at least `d` and less than `d + 1` degrees;
    /// of 60 entries the last includes 60.
    pub fn angles(&self) -> Vec<u32> {
        let scene = self.scene();
        let points: Vec<_> = scene.vertices().map(|(_, p)| p).collect();
        // A log that nobody has recorded may take a vertex away and leave its triangles.
        let is_whole = |t: &[VertexId; 3]| t.iter().all(|&v| scene.point(v).is_some());
        let triangles: Vec<_> = scene.triangles().filter(is_whole).collect();
        let counts = check::statistics(&points, &triangles).min_angles;
        counts.map(|count| count as u32).to_vec()
    }

    /// Returns the edges whose two triangles have their four corners on one circle, exactly: the ends, and the
    /// corners to the left and to the right. There the perturbation decides, and both diagonals would do.
    pub fn cocircular(&self) -> Vec<u32> {
        let found = quads(self.scene())
            .filter(|(_, [a, b, c, d])| in_circle(*a, *b, *c, *d) == CircleSide::On);
        json::indices(found.map(|(quad, _)| quad))
    }

    /// Returns the edges that are not locally Delaunay, perturbed as everywhere, nor locked: the ends, and the
    /// corners to the left and to the right.
    pub fn illegal(&self) -> Vec<u32> {
        let scene = self.scene();
        let found = quads(scene).filter(|&([v, w, ..], [a, b, c, d])| {
            in_circle_perturbed(a, b, c, d) && !scene.is_locked([v, w])
        });
        json::indices(found.map(|(quad, _)| quad))
    }

    /// Returns the circle through three vertices, rounded, as JSON: `{center: [x, y], radius}`; `null` if they lie
    /// on one line.
    pub fn circle(&self, a: u32, b: u32, c: u32) -> Result<String, Trouble> {
        let scene = self.scene();
        let [p, q, r] = positions(scene, [a, b, c])?;
        let turned = match orient2d(p, q, r) {
            Orientation::Right => [a, c, b],
            _ => [a, b, c],
        };
        let circle = scene.circle(turned.map(|v| VertexId::new(v as usize)));
        Ok(json::write(
            &circle.map(|(center, radius)| Circle { center, radius }),
        ))
    }

    /// Tells where the vertex `d` lies relative to the circle through three others, as JSON: `{side: "inside" |
    /// "on" | "outside", counts: "inside" | "outside"}`, which says what the perturbation makes of it; `null` if
    /// the three lie on one line.
    pub fn side(&self, a: u32, b: u32, c: u32, d: u32) -> Result<String, Trouble> {
        let [a, b, c, d] = positions(self.scene(), [a, b, c, d])?;
        let [a, b, c] = match orient2d(a, b, c) {
            Orientation::Left => [a, b, c],
            Orientation::Right => [a, c, b],
            Orientation::Collinear => return Ok("null".to_owned()),
        };
        let side = match in_circle(a, b, c, d) {
            CircleSide::Inside => "inside",
            CircleSide::On => "on",
            CircleSide::Outside => "outside",
        };
        let counts = match in_circle_perturbed(a, b, c, d) {
            true => "inside",
            false => "outside",
        };
        Ok(json::write(&Side { side, counts }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Drawing;
    use std::collections::BTreeSet;

    fn run(preset: &str) -> Player {
        let drawing = Drawing::preset(preset, 25, 1).expect("a preset");
        Player::run("flip-list", &drawing, None, None).expect("a run")
    }

    const PRESETS: [&str; 5] = ["uniform", "grid", "cocircular", "collinear", "thesis"];

    /// Finds the edges with two triangles by looking at all pairs of triangles, and asks the predicate in
    /// another order of the four.
    fn naive(
        player: &Player,
        holds: impl Fn([Point; 4], [VertexId; 2]) -> bool,
    ) -> BTreeSet<[u32; 4]> {
        let scene = player.scene();
        let triangles: Vec<_> = scene.triangles().collect();
        let turns = |[a, b, c]: [VertexId; 3]| [[a, b, c], [b, c, a], [c, a, b]];
        let mut found = BTreeSet::new();
        for [a, b, c] in triangles.iter().flat_map(|&t| turns(t)) {
            for [e, f, d] in triangles.iter().flat_map(|&t| turns(t)) {
                let points = [b, c, a, d].map(|v| scene.point(v).expect("a corner"));
                if a < b && [e, f] == [b, a] && holds(points, [a, b]) {
                    found.insert([a, b, c, d].map(|v| v.index() as u32));
                }
            }
        }
        found
    }

    fn rows(list: Vec<u32>) -> BTreeSet<[u32; 4]> {
        list.as_chunks().0.iter().copied().collect()
    }

    #[test]
    fn edges_are_judged_as_the_predicates_do() {
        let (mut illegal, mut cocircular) = (0, 0);
        for preset in PRESETS {
            let mut player = run(preset);
            for share in 0..=8 {
                player
                    .seek(player.length() * share / 8)
                    .expect("a step that fits");
                let bad = naive(&player, |[b, c, a, d], edge| {
                    in_circle_perturbed(b, c, a, d) && !player.scene().is_locked(edge)
                });
                assert_eq!(rows(player.illegal()), bad, "{preset}");
                illegal += bad.len();
                let on = naive(&player, |[b, c, a, d], _| {
                    in_circle(b, c, a, d) == CircleSide::On
                });
                assert_eq!(rows(player.cocircular()), on, "{preset}");
                cocircular += on.len();
            }
            assert!(
                player.illegal().is_empty(),
                "{preset}: it has come to its end"
            );
        }
        assert!(illegal > 0 && cocircular > 0);
    }

    #[test]
    fn angles_are_counted_once_a_triangle() {
        for preset in PRESETS {
            let mut player = run(preset);
            player.seek(u32::MAX).expect("the end");
            let counts = player.angles();
            assert_eq!(counts.len(), 60);
            assert_eq!(
                counts.iter().sum::<u32>() as usize,
                player.triangles().len() / 3
            );
            if preset == "grid" {
                assert_eq!(counts[45], counts.iter().sum::<u32>());
            }
        }
    }

    #[test]
    fn circles_and_sides_do_not_depend_on_the_order() {
        let drawing = Drawing::new(
            &[0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0, 4.0, 0.0],
            &[],
            &[],
        );
        let player =
            Player::run("incremental", &drawing.expect("points"), None, None).expect("a run");
        let circle = r#"{"center":[1.0,1.0],"radius":1.4142135623730951}"#;
        for [a, b, c] in [[0, 1, 2], [0, 2, 1]] {
            assert_eq!(player.circle(a, b, c).expect("vertices"), circle);
            // The largest corner gets no diagonal: for it the circle through the others is not empty.
            let on = player.side(a, b, c, 3).expect("vertices");
            assert_eq!(on, r#"{"side":"on","counts":"inside"}"#);
            let out = player.side(a, b, c, 4).expect("vertices");
            assert_eq!(out, r#"{"side":"outside","counts":"outside"}"#);
        }
        assert_eq!(player.circle(0, 1, 4).expect("vertices"), "null");
        assert_eq!(player.side(0, 1, 4, 2).expect("vertices"), "null");
        let error = player.side(0, 1, 2, 5).expect_err("no such vertex");
        assert!(error.to_string().contains("no vertex 5"));
    }
}
