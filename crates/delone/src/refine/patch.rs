//! What the move of one vertex changes: the faces around it and those that flips reach, as they were.
//!
//! A flip changes two faces and no others, so the faces that were touched cover the same part of the
//! domain before and after, and putting them back undoes everything.

use super::bounds::Bounds;
use super::canvas::{Canvas, Traits};
use super::worth::Worth;
use crate::predicates::{Orientation, in_circle_perturbed, orient2d};
use crate::{HalfEdgeId, Point, TriangleId, VertexId};

/// A face at some moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    pub id: TriangleId,
    pub points: [Point; 3],
    pub traits: Traits,
    pub region: u32,
    pub corners: [VertexId; 3],
    twins: [HalfEdgeId; 3],
}

impl Face {
    /// Takes down a face as it is now.
    pub fn of(canvas: &Canvas, id: TriangleId) -> Self {
        Self {
            id,
            points: canvas.triangle(id),
            traits: canvas.traits(id),
            region: canvas.region(id),
            corners: canvas.mesh.corners(id),
            twins: id.half_edges().map(|h| canvas.mesh.twin(h)),
        }
    }
}

/// The faces that a move has touched so far.
#[derive(Default)]
pub(super) struct Patch {
    faces: Vec<Face>,
    /// The last move that touched each face.
    touched: Vec<u32>,
    moves: u32,
    /// Edges that may have to be flipped.
    suspects: Vec<HalfEdgeId>,
}

impl Patch {
    /// Returns the faces as they were when the move began.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Moves the vertex from which `spoke` starts, flips edges after it, and keeps that if the faces that it
    /// changes are worth it; else all is as it was. Tells which.
    pub fn try_move(
        &mut self,
        canvas: &mut Canvas,
        bounds: &Bounds,
        spoke: HalfEdgeId,
        to: Point,
        is_worth_it: impl Fn(&Worth, &Worth) -> bool,
    ) -> bool {
        if !sees_its_star(canvas, spoke, to) {
            return false;
        }
        self.begin(canvas, spoke);
        let v = canvas.mesh.origin(spoke);
        let from = std::mem::replace(&mut canvas.points[v.index()], to);
        self.legalise(canvas);
        let before = Worth::of(bounds, self.faces.iter().copied());
        let after = self.faces.iter().map(|face| Face::of(canvas, face.id));
        let after = Worth::of(bounds, after);
        let is_kept = is_worth_it(&before, &after);
        if !is_kept {
            canvas.points[v.index()] = from;
            self.undo(canvas);
        }
        is_kept
    }

    /// Begins with the faces around the vertex from which `spoke` starts, before it moves.
    fn begin(&mut self, canvas: &Canvas, spoke: HalfEdgeId) {
        if self.moves == u32::MAX {
            self.touched.fill(0);
            self.moves = 0;
        }
        self.moves += 1;
        self.touched.resize(canvas.mesh.num_faces(), 0);
        self.faces.clear();
        self.suspects.clear();
        for h in canvas.mesh.star(spoke) {
            self.touch(canvas, h.triangle());
            self.suspects.extend([h, h.next()]);
        }
    }

    /// Takes a face down, unless that has been done.
    fn touch(&mut self, canvas: &Canvas, t: TriangleId) {
        let last = std::mem::replace(&mut self.touched[t.index()], self.moves);
        if last != self.moves {
            self.faces.push(Face::of(canvas, t));
        }
    }

    /// Flips edges, now that the vertex has moved, until every one is constrained or locally Delaunay.
    fn legalise(&mut self, canvas: &mut Canvas) {
        while let Some(h) = self.suspects.pop() {
            if !must_flip(canvas, h) {
                continue;
            }
            let g = canvas.mesh.twin(h);
            self.touch(canvas, h.triangle());
            self.touch(canvas, g.triangle());
            flip(canvas, h);
            self.suspects.extend([h, h.prev(), g, g.prev()]);
        }
    }

    /// Puts all faces back; the vertex is the caller's to put back.
    ///
    /// The last comes first: a face that was touched late may have been taken down with twins that a flip
    /// had already moved, in faces touched earlier, which know better.
    fn undo(&self, canvas: &mut Canvas) {
        for face in self.faces.iter().rev() {
            canvas.mesh.replace_face(face.id, face.corners);
            canvas.traits[face.id.index()] = face.traits;
            for (h, twin) in face.id.half_edges().into_iter().zip(face.twins) {
                canvas.mesh.bond(h, twin);
            }
        }
    }
}

/// Tells whether all triangles around a vertex stay counter-clockwise if it goes to another place.
fn sees_its_star(canvas: &Canvas, spoke: HalfEdgeId, to: Point) -> bool {
    let mut rim = canvas.mesh.star(spoke).map(|h| canvas.ends(h.next()));
    rim.all(|ends| {
        let [a, b] = ends.map(|v| canvas.point(v));
        orient2d(a, b, to) == Orientation::Left
    })
}

fn must_flip(canvas: &Canvas, h: HalfEdgeId) -> bool {
    if canvas.is_constrained(h) {
        return false;
    }
    let mesh = &canvas.mesh;
    let g = mesh.twin(h);
    let corners = [mesh.origin(h), mesh.dest(h), mesh.apex(h), mesh.apex(g)];
    let [a, b, c, d] = corners.map(|v| canvas.point(v));
    in_circle_perturbed(a, b, c, d)
}

/// Flips the edge of `h`; what is constrained stays so.
fn flip(canvas: &mut Canvas, h: HalfEdgeId) {
    let g = canvas.mesh.twin(h);
    let [bc, ad] = [h.next(), g.next()].map(|edge| canvas.is_constrained(edge));
    canvas.mesh.flip(h);
    canvas.set_constrained(h, ad);
    canvas.set_constrained(g, bc);
    canvas.set_constrained(h.next(), false);
    canvas.set_constrained(g.next(), false);
}
