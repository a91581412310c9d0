//! A vertex less.
//!
//! Spokes are flipped out of its star while that can be done, which leaves one of four pictures; the
//! vertex is then contracted into a neighbour, the one at infinity if it was on the hull, and the
//! triangles in its place are [made](crate::constrained::refill) constrained Delaunay. Outside of the
//! star nothing changes (Devillers, *On deletion in Delaunay triangulations*, 1999).
//!
//! ```text
//!      c                 c                  .--c--.             a ----- v ----- b
//!     /|\               /|\                / .   . \
//!    / v \             / | \              / .     . \          in a row, inside
//!   / . . \           a--v--b            a .       . b         or at its end
//!  /.     .\           \ | /                . \   / .
//! a ------- b           \|/               ghosts  v
//!                        d
//!  inside: three     on the segment      on the hull: no neighbour
//!  neighbours        between two         is left that could be cut off
//! ```
//!
//! *Cost*: linear in the degree, but for the last step.

use crate::constrained::{Draft, refill};
use crate::mesh::Moved;
use crate::predicates::{Orientation, is_between, orient2d};
use crate::{HalfEdgeId, TriangleId, VertexId};

/// Lists to work with, kept from one removal to the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Room {
    /// The faces that take the place of the star.
    pub faces: Vec<TriangleId>,
    pub suspects: Vec<HalfEdgeId>,
}

/// Removes a vertex; at least two must be left. No constrained edge may end there, but two may pass
/// straight on into each other: they become one.
///
/// Returns which faces have got new ids; the triangles in place of the star are in `room`.
pub(crate) fn remove(draft: &mut Draft, v: VertexId, room: &mut Room) -> [Moved; 2] {
    let Room { faces, suspects } = room;
    faces.clear();
    let first = draft
        .star(v)
        .next()
        .expect("bug: v is no vertex of the mesh");
    flatten(draft, first, faces);
    let spoke = target(draft, v);
    faces.extend(draft.star(v).map(HalfEdgeId::triangle));
    let gone = [spoke, draft.mesh.twin(spoke)].map(HalfEdgeId::triangle);
    faces.retain(|t| !gone.contains(t));
    let moved = draft.contract(spoke);
    for t in faces.iter_mut() {
        *t = moved.iter().fold(*t, |t, &moved| Moved::face(moved, t));
    }
    faces.retain(|&t| !draft.mesh.is_ghost(t));
    refill(draft, faces, suspects);
    moved
}

/// Flips spokes out of the star of the vertex from which `h` starts, as long as there are more than
/// three and one can be flipped, and lists the faces that are cut off.
///
/// As in Graham's scan, a flip makes new spokes eligible only next to it.
fn flatten(draft: &mut Draft, mut h: HalfEdgeId, faces: &mut Vec<TriangleId>) {
    let mut degree = draft.mesh.star(h).count();
    let mut unchecked = degree;
    while unchecked > 0 && degree > 3 {
        if can_flip(draft, h) {
            faces.push(draft.mesh.twin(h).triangle());
            // This makes h the spoke before it, clockwise.
            draft.flip(h);
            degree -= 1;
            unchecked = (unchecked - 1).max(1) + 1;
        } else {
            h = draft.mesh.onext(h);
            unchecked -= 1;
        }
    }
}

/// Tells whether the spoke `h` = vb may be replaced by the edge ac.
///
/// ```text
///      c
///     / \           both triangles must be triangles afterwards, too: b and v
///    v -- b         lie on different sides of ac
///     \ /
///      a
/// ```
fn can_flip(draft: &Draft, h: HalfEdgeId) -> bool {
    let mesh = &draft.mesh;
    let [v, a, b, c] = [
        mesh.origin(h),
        mesh.apex(mesh.twin(h)),
        mesh.dest(h),
        mesh.apex(h),
    ];
    if draft.marks.is_constrained(h) || [a, b, c].iter().any(|w| w.is_infinite()) {
        return false;
    }
    let [v, a, b, c] = [v, a, b, c].map(|w| draft.point(w));
    orient2d(a, b, c) == Orientation::Left && orient2d(a, c, v) == Orientation::Left
}

/// Chooses the spoke of a flattened star along which the vertex is contracted.
fn target(draft: &Draft, v: VertexId) -> HalfEdgeId {
    let mesh = &draft.mesh;
    let is_infinite = |&h: &HalfEdgeId| mesh.dest(h).is_infinite();
    let found = match draft.star(v).count() {
        2 | 3 => draft.star(v).find(|h| !is_infinite(h)),
        4 => {
            let between = draft.star(v).find(|&h| slides(draft, h));
            between.or_else(|| draft.star(v).find(is_infinite))
        }
        _ => draft.star(v).find(is_infinite),
    };
    found.expect("bug: a star that is visible from within has an ear")
}

/// Tells whether a vertex of degree four lies between two neighbours, the first one that of spoke `h`,
/// and does not interrupt another constrained edge.
fn slides(draft: &Draft, h: HalfEdgeId) -> bool {
    let mesh = &draft.mesh;
    let beside = mesh.onext(h);
    let [v, a, b] = [mesh.origin(h), mesh.dest(h), mesh.dest(mesh.onext(beside))];
    if a.is_infinite() || b.is_infinite() || draft.marks.is_constrained(beside) {
        return false;
    }
    let [v, a, b] = [v, a, b].map(|w| draft.point(w));
    is_between(a, b, v)
}

#[cfg(test)]
mod tests {
    //! In unit tests every second hole is refilled in bulk.

    use crate::edit::LiveTriangulation;
    use crate::{ConstrainedDelaunay, Pslg, VertexId, triangulate};

    fn v(i: usize) -> VertexId {
        VertexId::new(i)
    }

    fn live(points: &[(f64, f64)]) -> LiveTriangulation {
        LiveTriangulation::from(&triangulate(points.iter().copied()).expect("finite points"))
    }

    fn rim(k: u32) -> Vec<(f64, f64)> {
        let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(k);
        (0..k).map(|i| (angle(i).cos(), angle(i).sin())).collect()
    }

    #[test]
    fn a_wheel_loses_its_hub() {
        for k in 3..40 {
            let rim = rim(k);
            let mut points = rim.clone();
            points.push((0.25, 0.125));
            let mut live = live(&points);
            live.remove(v(points.len() - 1)).expect("a vertex");
            live.mesh().validate().expect("a sphere");
            assert_eq!(live.hash(), triangulate(rim).unwrap().hash(), "{k} spokes");
        }
    }

    #[test]
    fn a_hub_on_a_constraint_leaves_a_hole_in_two_parts() {
        for k in (8..40).step_by(4) {
            let rim = rim(k);
            let mut points = rim.clone();
            points.push((0.0, 0.0));
            // From left to right, exactly through the hub.
            points.extend([(-1.5, 0.0), (1.5, 0.0)]);
            let [hub, left, right] = [0, 1, 2].map(|i| v(rim.len() + i));
            let mut live = live(&points);
            // On the circle these two lie on the line, but for rounding.
            live.remove(v(0)).expect("a vertex");
            live.remove(v(k as usize / 2)).expect("a vertex");
            let id = live
                .add_constraint(left, right)
                .expect("nothing in the way");
            assert_eq!(live.chain(id), Some(vec![left, hub, right]));
            live.remove(hub).expect("a vertex");
            live.mesh().validate().expect("a sphere");
            let snapshot = live.snapshot();
            let mut pslg = Pslg::from_points(
                snapshot
                    .triangulation
                    .triangulation()
                    .points()
                    .iter()
                    .copied(),
            );
            pslg.segments = snapshot.triangulation.segments().to_vec();
            let fresh = ConstrainedDelaunay::new().triangulate(pslg).unwrap();
            assert_eq!(live.hash(), fresh.triangulation().hash(), "{k} spokes");
        }
    }

    /// Every star of a lattice, and every shape that is left on the way to nothing.
    #[test]
    fn a_lattice_is_taken_apart() {
        for side in 2..8usize {
            for step in [1, 5, 11, 13] {
                let points: Vec<_> = (0..side * side)
                    .map(|i| ((i % side) as f64, (i / side) as f64))
                    .collect();
                let mut live = live(&points);
                for i in 0..points.len() {
                    let victim = (i + 1) * step * side.pow(2).next_power_of_two() / 7;
                    let nth = victim % live.num_vertices();
                    let victim = live.vertices().nth(nth).expect("some are left");
                    live.remove(victim).expect("a vertex");
                    live.mesh().validate().expect("a sphere");
                    let left: Vec<_> = live.vertices().filter_map(|v| live.point(v)).collect();
                    let fresh = triangulate(left).unwrap();
                    assert_eq!(live.hash(), fresh.hash());
                    assert_eq!(live.mesh().num_faces(), fresh.mesh().num_faces());
                }
            }
        }
    }
}
