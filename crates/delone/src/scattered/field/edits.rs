//! Edits of the mesh; the data of what changes are dealt out anew.

use super::Field;
use super::around::MANY;
use crate::delaunay::{Growing, check_number, insert};
use crate::edit::remove;
use crate::locate::Location;
use crate::predicates::{Orientation, in_circle_perturbed, orient2d};
use crate::scattered::share::{Parts, share};
use crate::scattered::stock::Held;
use crate::{Error, Event, HalfEdgeId, Observer, Point, TriangleId, VertexId};

impl<O: Observer> Field<'_, O> {
    /// Makes a vertex on which nothing hangs yet.
    ///
    /// # Errors
    /// [`Error::TooManyPoints`].
    pub fn create_vertex(&mut self, at: Point) -> Result<VertexId, Error> {
        check_number(self.data.given.len() + self.draft.points.len() + 1)?;
        let v = VertexId::new(self.draft.points.len());
        self.draft.set_point(v, at);
        let vertex = self.name(v);
        self.tell(|| Event::VertexCreated { vertex, at });
        Ok(v)
    }

    /// Puts a vertex on which nothing hangs elsewhere.
    pub fn move_vertex(&mut self, v: VertexId, to: Point) {
        let from = self.draft.point(v);
        self.draft.set_point(v, to);
        let vertex = self.name(v);
        if from != to {
            self.tell(|| Event::VertexMoved { vertex, from, to });
        }
    }

    /// Joins a vertex to the Delaunay triangulation where it lies, near triangle `hint`; false if there is another
    /// vertex, or if it lies outside, or on the outline, which need not be convex and could not be restored.
    pub fn insert(&mut self, v: VertexId, hint: TriangleId) -> Result<bool, Error> {
        let p = self.draft.point(v);
        let Some(t) = self.find(p, hint)? else {
            return Ok(false);
        };
        let Some(at) = self.within(t, p) else {
            return Ok(false);
        };
        insert(&mut self.draft, at, v, &mut self.room.suspects).expect("bug: no vertex is there");
        self.stock.set_number(self.draft.mesh.num_faces());
        let star = self.draft.star(v).map(HalfEdgeId::triangle);
        let mut faces: Vec<_> = star.filter(|&t| !self.draft.mesh.is_ghost(t)).collect();
        faces.sort_unstable();
        let held = self.take_all(faces.iter().copied());
        if faces.len() < MANY {
            self.deal(&held, &faces)?;
        } else {
            self.deal_around(v, &held)?;
        }
        self.tell_changes();
        Ok(true)
    }

    /// Where in a closed triangle a point lies; `None` if on a vertex, or on an outer edge.
    fn within(&self, t: TriangleId, p: Point) -> Option<Location> {
        let is_on = |&h: &HalfEdgeId| self.draft.side_of(h, p) == Orientation::Collinear;
        let mut on = t.half_edges().into_iter().filter(is_on);
        match (on.next(), on.next()) {
            (None, _) => Some(Location::Face(t)),
            (Some(h), None) => (!self.is_outer(h)).then_some(Location::Edge(h)),
            _ => None,
        }
    }

    /// Takes a vertex inside of the outline out of the Delaunay triangulation, and returns a triangle where it lay.
    pub fn remove(&mut self, v: VertexId) -> Result<TriangleId, Error> {
        let star: Vec<_> = self.draft.star(v).map(HalfEdgeId::triangle).collect();
        let held = self.take_all(star);
        let mut room = std::mem::take(&mut self.room);
        for moved in remove(&mut self.draft, v, &mut room) {
            self.stock.follow(moved);
        }
        room.faces.sort_unstable();
        let dealt = self.deal(&held, &room.faces);
        let there = room.faces[0];
        self.room = room;
        dealt?;
        self.tell_changes();
        Ok(there)
    }

    /// Takes the data of some triangles, those of the lowest first.
    fn take_all(&mut self, faces: impl IntoIterator<Item = TriangleId>) -> Vec<Held> {
        let mut faces: Vec<_> = faces.into_iter().collect();
        faces.sort_unstable();
        let taken = faces.into_iter().flat_map(|t| self.stock.take(t));
        taken.collect()
    }

    /// Puts a vertex into triangle `t`; `shares` says for each datum that it holds to which part it goes: part k is
    /// opposite corner k. It must lie there.
    pub fn divide_triangle(
        &mut self,
        t: TriangleId,
        at: Point,
        shares: &[u8],
    ) -> Result<VertexId, Error> {
        let v = self.create_vertex(at)?;
        let held = self.stock.take(t);
        let [of_ab, of_bc, of_ca] = self.draft.split_face(t, v);
        self.hand_out(&held, shares, &[of_bc, of_ca, of_ab]);
        self.tell_changes();
        Ok(v)
    }

    /// Puts a vertex into the quadrilateral of an edge, or on an outer edge, and joins it to its corners; `shares`
    /// says for each datum that the triangle of `h`, and then the one beyond, hold, to which part it goes.
    ///
    /// ```text
    ///           c                   Parts 0 to 3 are avc, adv, dbv, vbc; on an outer edge 0 is avc, and
    ///          /|\                  1 is vbc.
    ///         / | \
    ///        / 0|3 \
    ///       a --v-- b               h = ab, left of it c
    ///        \ 1|2 /
    ///         \ | /
    ///          \|/
    ///           d
    /// ```
    pub fn divide_edge(
        &mut self,
        h: HalfEdgeId,
        at: Point,
        shares: &[u8],
    ) -> Result<VertexId, Error> {
        let is_outer = self.is_outer(h);
        let v = self.create_vertex(at)?;
        if let Some(rim) = self.rim.as_mut().filter(|_| is_outer) {
            rim.divide(self.draft.mesh.origin(h), v, at);
        }
        let mut held = self.stock.take(h.triangle());
        if !is_outer {
            let twin = self.draft.mesh.twin(h);
            held.extend(self.stock.take(twin.triangle()));
        }
        let [ca, ad, db, bc] = self.draft.split_edge(h, v);
        let parts = [ca, ad, db, bc];
        let outer_parts = [ca, bc];
        let parts: &[_] = if is_outer { &outer_parts } else { &parts };
        self.hand_out(&held, shares, parts);
        self.tell_changes();
        Ok(v)
    }

    /// Gives data to the triangles of these half-edges, as `shares` says.
    fn hand_out(&mut self, held: &[Held], shares: &[u8], parts: &[HalfEdgeId]) {
        debug_assert_eq!(held.len(), shares.len());
        self.stock.set_number(self.draft.mesh.num_faces());
        let corners: Vec<_> = parts.iter().map(|h| self.corners(h.triangle())).collect();
        for (held, &part) in held.iter().zip(shares) {
            let p = self.data.points[held.datum()];
            let is_on_border = super::deal::contains(&corners[part as usize], p);
            let is_on_border =
                is_on_border.expect("bug: a datum was given to a triangle where it is not");
            let t = parts[part as usize].triangle();
            self.stock.give(t, Held::new(held.datum(), is_on_border));
        }
        for h in parts {
            self.stock.touch(h.triangle());
        }
    }

    /// The swap test of the extended max-min-angle criterion, and the swap: flips an edge if that makes the smallest
    /// angle of its two triangles larger, and leaves both at least `least` data.
    ///
    /// Ties are broken by the perturbation, as everywhere.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn swap(&mut self, h: HalfEdgeId, least: usize) -> Result<bool, Error> {
        if self.draft.marks.is_constrained(h) || self.is_outer(h) {
            return Ok(false);
        }
        let g = self.draft.mesh.twin(h);
        let [a, b, c] = self.edge(h);
        let d = self.edge(g)[2];
        self.spend(1)?;
        if !in_circle_perturbed(a, b, c, d) {
            return Ok(false);
        }
        let sides = [h, g].into_iter().flat_map(|s| self.data_of(s.triangle()));
        let options: Vec<Parts> = sides
            .map(|p| match orient2d(d, c, p) {
                Orientation::Left => 0b01,
                Orientation::Collinear => 0b11,
                Orientation::Right => 0b10,
            })
            .collect();
        self.spend(options.len())?;
        let Some(shares) = share(&options, 2, least) else {
            return Ok(false);
        };
        let from = [h, g].map(|s| self.draft.mesh.origin(s));
        let to = [h, g].map(|s| self.draft.mesh.apex(s));
        let mut held = self.stock.take(h.triangle());
        held.extend(self.stock.take(g.triangle()));
        self.draft.flip(h);
        self.hand_out(&held, &shares, &[h, g]);
        self.tell_flip(from, to);
        Ok(true)
    }
}
