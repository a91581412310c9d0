//! Location as the lecture does it: a breadth-first search over the faces, and a look at every outer edge.

use super::Board;
use crate::locate::Location;
use crate::observe::{Item, Queue};
use crate::predicates::Orientation;
use crate::{Event, HalfEdgeId, Observer, TriangleId, VertexId};
use std::collections::VecDeque;

impl<O: Observer> Board<'_, O> {
    /// Searches the triangles breadth-first for one that holds `p`, which is no vertex yet: where `p` lies, or
    /// `None` if it lies outside.
    ///
    /// *Cost*: linear; up to three orientation tests a triangle.
    pub fn search(&mut self, p: VertexId) -> Option<Location> {
        let first = self.mesh().triangles().next()?;
        let mut seen = vec![false; self.mesh().num_faces()];
        let mut waiting = VecDeque::new();
        self.await_face(first, &mut seen, &mut waiting);
        while let Some(t) = waiting.pop_front() {
            self.tell_search(t, false);
            let triangle = self.mesh().corners(t);
            self.tell(|| Event::TriangleVisited { triangle });
            if let Some(at) = self.place_in(t, p) {
                for t in waiting {
                    self.tell_search(t, false);
                }
                return Some(at);
            }
            for h in t.half_edges() {
                let beyond = self.mesh().twin(h).triangle();
                self.await_face(beyond, &mut seen, &mut waiting);
            }
        }
        None
    }

    /// Lets a triangle wait for the search, once.
    fn await_face(&mut self, t: TriangleId, seen: &mut [bool], waiting: &mut VecDeque<TriangleId>) {
        if !seen[t.index()] && !self.mesh().is_ghost(t) {
            seen[t.index()] = true;
            self.tell_search(t, true);
            waiting.push_back(t);
        }
    }

    fn tell_search(&mut self, t: TriangleId, is_pushed: bool) {
        let item = Item::Triangle(self.mesh().corners(t));
        self.tell_waiting(Queue::Search, item, is_pushed);
    }

    /// Says where `p` lies in a triangle or on its rim; `None`: it lies elsewhere.
    fn place_in(&mut self, t: TriangleId, p: VertexId) -> Option<Location> {
        let mut at = Location::Face(t);
        for h in t.half_edges() {
            let [a, b] = self.ends(h);
            match self.orient(a, b, p) {
                Orientation::Left => {}
                Orientation::Collinear => at = Location::Edge(h),
                Orientation::Right => return None,
            }
        }
        Some(at)
    }

    /// Tells where a point lies.
    pub fn tell_located(&mut self, vertex: VertexId, at: Option<Location>) {
        let at = at.and_then(|at| match at {
            Location::Face(t) => Some(Item::Triangle(self.mesh().corners(t))),
            Location::Edge(h) => Some(Item::Edge(self.ends(h))),
            Location::Vertex(v) => Some(Item::Vertex(v)),
            _ => None,
        });
        self.tell(|| Event::PointLocated { vertex, at });
    }

    /// Looks at every outer half-edge a → c, and returns those with (a, c, p) counter-clockwise in their
    /// order around the outer face, which is clockwise.
    pub fn outer_edges_seen(&mut self, p: VertexId) -> Vec<HalfEdgeId> {
        let ghost = self.mesh().ghosts().next();
        let first = self.mesh().hull_edge_of(ghost.expect("bug: no outer face"));
        let mut outer: Vec<_> = self.mesh().hull(first).collect();
        outer.reverse();
        let sees: Vec<_> = outer
            .iter()
            .map(|&h| {
                let [a, c] = self.ends(h);
                self.orient(a, c, p) == Orientation::Left
            })
            .collect();
        // The hull is convex: what is seen is one run, which may go over the end of the list.
        let n = outer.len();
        let begins = |&i: &usize| sees[i] && !sees[(i + n - 1) % n];
        let begin = (0..n).find(begins).expect("bug: nothing is seen");
        let run = (begin..begin + n).take_while(|i| sees[i % n]);
        run.map(|i| outer[i % n]).collect()
    }
}
