//! Passes data on edges and vertices on, from triangle to triangle, until one holds enough, or not too many.
//!
//! Which triangle a datum on an edge counts for is free. So whether every triangle can hold enough is a question of
//! flows: one that holds too few gets a datum from a neighbour, that one another from the next, until one can spare
//! one (Ford and Fulkerson, 1956). If no such chain begins at a triangle, there is none after others have been
//! changed either, and no choice satisfies all.

use super::Field;
use super::deal::contains;
use crate::{HalfEdgeId, Observer, TriangleId, VertexId};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// How a triangle was come to: the other one, and the place in its list, or in this one's, of the datum to pass on.
#[derive(Clone, Copy)]
struct Link {
    from: TriangleId,
    place: usize,
}

/// Who gets.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// The triangle where the chain begins gets a datum; where it ends one can be spared.
    In,
    /// It gives one away; where the chain ends there is room.
    Out,
}

impl<O: Observer> Field<'_, O> {
    /// Lets triangle `t` hold at least `least` data, and no other fewer than that which did not already; false if that
    /// is impossible.
    ///
    /// *Cost*: for each datum linear in the triangles that share data on edges, at worst; a few in practice.
    pub fn raise(&mut self, t: TriangleId, least: usize) -> bool {
        while self.stock.count(t) < least {
            if !self.pass(t, Way::In, |count| count > least) {
                return false;
            }
        }
        true
    }

    /// Lets triangle `t` hold at most `most` data, and no other more than that which did not already; false if that is
    /// impossible.
    pub fn lower(&mut self, t: TriangleId, most: usize) -> bool {
        while self.stock.count(t) > most {
            if !self.pass(t, Way::Out, |count| count < most) {
                return false;
            }
        }
        true
    }

    /// Counts the data in a closed triangle, whoever holds them.
    pub fn most_that_could_be_held(&self, t: TriangleId) -> usize {
        let corners = self.corners(t);
        let may = |w: &TriangleId| {
            let held = self.stock.held(*w).iter();
            let candidates = held.filter(|held| held.may_be_on_border());
            let there = candidates.filter(|held| {
                let p = self.data.points[held.datum()];
                contains(&corners, p).is_some()
            });
            there.count()
        };
        let around = self.around(t, Way::In, &mut BTreeSet::new());
        let from_others: usize = around.iter().map(may).sum();
        self.stock.count(t) + from_others
    }

    /// Passes one datum along each link of a chain from `t` to a triangle that is an end; false if there is none.
    fn pass(&mut self, t: TriangleId, way: Way, is_end: impl Fn(usize) -> bool) -> bool {
        let mut links: BTreeMap<TriangleId, Option<Link>> = BTreeMap::from([(t, None)]);
        let mut seen = BTreeSet::new();
        let mut queue = VecDeque::from([t]);
        while let Some(u) = queue.pop_front() {
            for w in self.around(u, way, &mut seen) {
                if links.contains_key(&w) {
                    continue;
                }
                let found = match way {
                    Way::In => self.common(w, u),
                    Way::Out => self.common(u, w),
                };
                let Some(place) = found else { continue };
                links.insert(w, Some(Link { from: u, place }));
                if is_end(self.stock.count(w)) {
                    self.pass_along(&links, w, way);
                    return true;
                }
                queue.push_back(w);
            }
        }
        false
    }

    /// Passes data along the chain that has come to `w`.
    fn pass_along(&mut self, links: &BTreeMap<TriangleId, Option<Link>>, w: TriangleId, way: Way) {
        let mut at = w;
        let mut steps = Vec::new();
        while let Some(Link { from, place }) = links[&at] {
            steps.push(match way {
                Way::In => (at, place, from),
                Way::Out => (from, place, at),
            });
            at = from;
        }
        // Each triangle loses one datum at most, and what it gets comes last in its list: places stay right.
        for (giver, place, taker) in steps {
            self.stock.pass_on(giver, place, taker);
        }
        self.tell_changes();
    }

    /// Finds the first datum that `giver` holds and `taker` could.
    fn common(&self, giver: TriangleId, taker: TriangleId) -> Option<usize> {
        let corners = self.corners(taker);
        let held = self.stock.held(giver).iter();
        let mut candidates = held.enumerate().filter(|(_, held)| held.may_be_on_border());
        let found = candidates.find(|(_, held)| {
            let p = self.data.points[held.datum()];
            contains(&corners, p).is_some()
        });
        found.map(|(place, _)| place)
    }

    /// Lists other triangles that could give a datum to `u`, or take one from it, ascending: those beyond its edges, and
    /// those at its vertices.
    ///
    /// At most one datum lies on a vertex. Whoever holds it gives it to the first who asks: so at vertices that have
    /// been seen nobody is to be asked again, or a hub would make this quadratic. Takers of a datum on a vertex are
    /// looked for by its holder alone.
    fn around(&self, u: TriangleId, way: Way, seen: &mut BTreeSet<VertexId>) -> Vec<TriangleId> {
        let mesh = &self.draft.mesh;
        let mut around: Vec<_> = u.half_edges().map(|h| mesh.twin(h).triangle()).to_vec();
        for h in u.half_edges() {
            let v = mesh.origin(h);
            let is_new = match way {
                Way::In => seen.insert(v),
                Way::Out => self.holds_at(u, v),
            };
            if is_new {
                around.extend(mesh.star(h).map(HalfEdgeId::triangle));
            }
        }
        around.sort_unstable();
        around.dedup();
        around.retain(|&w| w != u && !mesh.is_ghost(w));
        around
    }

    /// Tells whether a triangle holds a datum that lies on a vertex.
    fn holds_at(&self, t: TriangleId, v: VertexId) -> bool {
        let at = self.draft.point(v);
        self.data_of(t).any(|p| p == at)
    }
}
