//! The default strategy, told to an observer: before each vertex why it comes, then what changes for it.
//!
//! The loop says what it is about to do, and which faces it is about to change. What has changed is the difference
//! of two [pictures](Picture) of these, so that no edit of the mesh has to be told by itself. Vertices have the
//! numbers of the result: those that were there the caller's, new ones the next that is free.
//!
//! | a vertex is added | told before `VertexCreated` |
//! |---|---|
//! | because a triangle is skinny | `CircumcenterProposed` |
//! | because a triangle is too large | `TriangleConsidered`, `CircumcenterProposed` |
//! | because its longest edge, a subsegment, is too long | `TriangleConsidered`, `SegmentSplit` |
//! | because a subsegment is in the way of a place | as above, but `CircumcenterRejected`, `SegmentSplit` after it |
//! | because a vertex is too close to a subsegment | `Encroached`, `SegmentSplit` |
//!
//! *Cost*: none for who does not observe: the compiler leaves nothing of it.

use super::canvas::{Canvas, Traits};
use super::code;
use super::patch::Face;
use super::picture::Picture;
use crate::constrained::Prepared;
use crate::{Event, Observer, Point, Stage, TriangleId, VertexId};

/// Tells of the domain that refinement begins with; what is seen of it, if anybody watches.
pub(super) fn tell_start(prepared: &Prepared, observer: &mut impl Observer) -> Option<Picture> {
    if !observer.is_watching() {
        return None;
    }
    let context = &prepared.context;
    let points = &context.pslg.points;
    let mut shown = Picture::of_points(points.len() - context.lineage.crossings.len());
    shown.turn_into(of_domain(prepared), points, 0, observer);
    tell_end(code::TRIANGULATE, Stage::InsideTest, observer);
    Some(shown)
}

/// Tells of the lattice that has been sown since.
pub(super) fn tell_sown(shown: Option<Picture>, prepared: &Prepared, observer: &mut impl Observer) {
    if let Some(mut shown) = shown {
        let points = &prepared.context.pslg.points;
        shown.turn_into(of_domain(prepared), points, code::SOW, observer);
        tell_end(code::SOW, Stage::Lattice, observer);
    }
}

fn tell_end(line: u16, stage: Stage, observer: &mut impl Observer) {
    let min_angle = None;
    observer.tell(line, || Event::StageEnded { stage, min_angle });
}

/// What is to be seen of a domain.
fn of_domain(prepared: &Prepared) -> Picture {
    let (faces, context) = (&prepared.faces, &prepared.context);
    let name = |v: VertexId| context.names.callers.get(v.index()).copied().unwrap_or(v);
    let all = (0..faces.outside.len()).map(TriangleId::new);
    let all = all.map(|t| {
        let corners = faces.mesh.corners(t).map(name);
        (
            corners,
            faces.constrained[t.index()],
            faces.outside[t.index()],
        )
    });
    Picture::of_faces(context.pslg.points.len(), all)
}

/// Who tells, while the loop runs.
pub(super) struct Teller<'o, O> {
    observer: &'o mut O,
    /// What the caller calls the vertices that were there before the loop.
    callers: Vec<VertexId>,
    /// Coordinates are those of the result times this power of two.
    scale: f64,
    line: u16,
    /// Why the next vertex comes, with the lines.
    causes: Vec<(u16, Event)>,
}

impl<'o, O: Observer> Teller<'o, O> {
    pub fn new(prepared: &Prepared, scale: f64, observer: &'o mut O) -> Self {
        let callers = match observer.is_watching() {
            true => prepared.context.names.callers.clone(),
            false => Vec::new(),
        };
        Self {
            observer,
            callers,
            scale,
            line: code::LOOP,
            causes: Vec::new(),
        }
    }

    /// Goes to a line of the pseudocode.
    #[inline]
    pub fn at(&mut self, line: u16) {
        if self.observer.is_watching() {
            self.line = line;
        }
    }

    /// Names vertices as the result does.
    pub fn names<const N: usize>(&self, vertices: [VertexId; N]) -> [VertexId; N] {
        vertices.map(|v| self.callers.get(v.index()).copied().unwrap_or(v))
    }

    /// Tells of something.
    #[inline]
    pub fn tell(&mut self, event: impl FnOnce(&Self) -> Event) {
        if self.observer.is_watching() {
            let event = event(self);
            self.observer.tell(self.line, || event);
        }
    }

    /// Remembers a cause of the vertex that may come; to be told if it does.
    #[inline]
    pub fn because(&mut self, line: u16, event: impl FnOnce(&Self) -> Event) {
        if self.observer.is_watching() {
            let event = event(self);
            self.causes.push((line, event));
        }
    }

    /// Forgets causes: nothing has come of them.
    #[inline]
    pub fn forget(&mut self) {
        if self.observer.is_watching() {
            self.causes.clear();
        }
    }

    /// Tells why a vertex comes, and where it lies.
    #[inline]
    pub fn tell_vertex(&mut self, vertex: VertexId, at: Point) {
        if self.observer.is_watching() {
            for (line, event) in std::mem::take(&mut self.causes) {
                self.observer.tell(line, || event);
            }
            let at = self.unscaled(at);
            self.tell(|_| Event::VertexCreated { vertex, at });
        }
    }

    /// Tells that a triangle is left as it is.
    #[inline]
    pub fn tell_left(&mut self, corners: [VertexId; 3]) {
        self.forget();
        self.tell(|teller| Event::DivisionFailed {
            triangle: teller.names(corners),
        });
    }

    /// Looks at faces before they change; nothing if nobody watches.
    #[inline]
    pub fn before(&self, canvas: &Canvas, faces: &[TriangleId]) -> Option<Picture> {
        let is_watching = self.observer.is_watching();
        is_watching.then(|| self.picture(faces.iter().map(|&t| now(canvas, t))))
    }

    /// Tells what has become of faces, new ones among them.
    #[inline]
    pub fn after(&mut self, before: Option<Picture>, canvas: &Canvas, faces: &[TriangleId]) {
        if let Some(mut before) = before {
            let after = self.picture(faces.iter().map(|&t| now(canvas, t)));
            before.turn_into(after, &[], self.line, self.observer);
        }
    }

    /// Tells that a vertex has moved, and what has become of `faces`, which are as they were before.
    #[inline]
    pub fn tell_move(&mut self, canvas: &Canvas, v: VertexId, from: Point, faces: &[Face]) {
        if !self.observer.is_watching() {
            return;
        }
        let [vertex] = self.names([v]);
        let mut shown = self.picture(faces.iter().map(|face| (face.corners, face.traits)));
        let after = self.picture(faces.iter().map(|face| now(canvas, face.id)));
        shown.turn_into(shown.common(&after, vertex), &[], self.line, self.observer);
        let [from, to] = [from, canvas.point(v)].map(|p| self.unscaled(p));
        self.tell(|_| Event::VertexMoved { vertex, from, to });
        shown.turn_into(after, &[], self.line, self.observer);
    }

    /// Tells that a part of the work is done.
    pub fn end(&mut self, line: u16, stage: Stage) {
        tell_end(line, stage, self.observer);
    }

    /// Where a point of the canvas lies in the result.
    pub fn unscaled(&self, p: Point) -> Point {
        Point::new(p.x / self.scale, p.y / self.scale)
    }

    fn picture(&self, faces: impl Iterator<Item = ([VertexId; 3], Traits)>) -> Picture {
        let named =
            faces.map(|(corners, traits)| (self.names(corners), traits.0, traits.is_outside()));
        Picture::of_faces(0, named)
    }
}

/// A face as it is.
fn now(canvas: &Canvas, t: TriangleId) -> ([VertexId; 3], Traits) {
    (canvas.mesh.corners(t), canvas.traits(t))
}
