//! The hole that a new site tears into the triangulation, and how it is filled.
//!
//! The faces in conflict with a site that is not hidden form a disc, ghosts included: they are what it
//! sees of a convex hull. Vertices inside the disc vanish; they are hidden by the site for ever.
//!
//! ```text
//!        .--<--.                       .-----.
//!       / \ | / \                     / \ . / \      k vertices inside a rim of n edges:
//!      '---- x ---'         →        '---- v ---'    n − 2 + 2k faces before, n after.
//!       \ /  | \ /                    \ / . \ /
//!        '-->--'                       '-----'
//! ```
//!
//! Depth first, the search meets the rim counter-clockwise. Edges where it comes upon a face that it
//! has been in are cuts to a vertex inside: it passes each once on either side, and skips both.

use super::insert::Growing;
use crate::{HalfEdgeId, Mesh, TriangleId, VertexId};

/// Faces in conflict with a site, and the edges around them.
#[derive(Debug, Default)]
pub(super) struct Cavity {
    faces: Vec<TriangleId>,
    /// The half-edges of the faces beyond, counter-clockwise around the cavity.
    rim: Vec<HalfEdgeId>,
    stack: Vec<HalfEdgeId>,
    /// For each face the last vertex whose cavity it has been in.
    visited: Vec<VertexId>,
}

impl Cavity {
    /// Finds the cavity of `v`, beginning at face `t`, which must be in conflict.
    pub fn dig(&mut self, growing: &Growing, t: TriangleId, v: VertexId) {
        self.faces.clear();
        self.rim.clear();
        self.visited
            .resize(growing.mesh.num_faces(), VertexId::INFINITE);
        self.enter(t, v);
        let [a, b, c] = t.half_edges();
        self.stack.extend([c, b, a]);
        while let Some(h) = self.stack.pop() {
            let outer = growing.mesh.twin(h);
            let beyond = outer.triangle();
            if self.visited[beyond.index()] == v {
                continue;
            }
            if growing.conflicts(beyond, v) {
                self.enter(beyond, v);
                self.stack.extend([outer.prev(), outer.next()]);
            } else {
                self.rim.push(outer);
            }
        }
    }

    fn enter(&mut self, t: TriangleId, v: VertexId) {
        self.visited[t.index()] = v;
        self.faces.push(t);
    }

    /// Fills the cavity with faces around vertex `v` and returns a half-edge of one of them. Faces that
    /// are left over are appended to `free`, and taken from there when they are too few.
    ///
    /// *Ids invalidated*: all half-edges in the cavity.
    pub fn fill(&mut self, mesh: &mut Mesh, free: &mut Vec<TriangleId>, v: VertexId) -> HalfEdgeId {
        mesh.fill(&mut self.faces, &self.rim, free, v)
    }
}
