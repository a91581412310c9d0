//! What there is to see between two steps, forwards and backwards.

use super::naming::ascending;
use super::{Event, Item, Queue, Sweep};
use crate::predicates::{Orientation, circumcenter, orient2d};
use crate::{Point, TriangulationHash, VertexId, hash_triangles};
use std::collections::{BTreeMap, BTreeSet};

/// Vertices, edges, triangles, constraints, front, queues: all that steps change.
///
/// A scene believes nothing: an event that does not fit what is there is refused, so a log that can be
/// played is consistent. The mesh is a set of triangles; how it was stored is not told.
///
/// ```
/// use delone::{Event, Scene, VertexId};
/// let edge = [0, 1].map(VertexId::new);
/// let mut scene = Scene::new([(0.0, 0.0), (1.0, 0.0)]);
/// scene.apply(Event::EdgeCreated { edge })?;
/// assert_eq!(scene.edges().count(), 1);
/// scene.apply(Event::EdgeCreated { edge }).unwrap_err(); // there is one already
/// scene.revert(Event::EdgeCreated { edge })?;
/// assert_eq!(scene, Scene::new([(0.0, 0.0), (1.0, 0.0)]));
/// # Ok::<(), delone::NoSuchStep>(())
/// ```
///
/// *Cost*: O(log n) a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    points: Vec<Point>,
    /// How many edges hang on each vertex.
    degrees: Vec<u32>,
    /// Smaller end first.
    edges: BTreeSet<[VertexId; 2]>,
    locked: BTreeSet<[VertexId; 2]>,
    /// The apex of each directed edge that has a triangle on its left.
    apexes: BTreeMap<[VertexId; 2], VertexId>,
    front: Front,
    sweep: Option<Sweep>,
    queues: BTreeMap<Queue, BTreeMap<Item, usize>>,
    data: BTreeMap<VertexId, [VertexId; 3]>,
    clusters: BTreeMap<u32, Point>,
}

/// The places of a front in their order.
#[derive(Clone, Debug, Default, PartialEq)]
struct Front {
    first: Option<u32>,
    places: BTreeMap<u32, Place>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    vertex: VertexId,
    before: Option<u32>,
    after: Option<u32>,
}

/// A step that does not fit the scene: the log is not that of a run, or not played in its order.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{event:?} does not fit what is there: {why}")]
pub struct NoSuchStep {
    /// The event.
    pub event: Event,
    /// What is wrong.
    pub why: &'static str,
}

impl Scene {
    /// Begins with points alone.
    pub fn new<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        let points: Vec<_> = points.into_iter().map(Into::into).collect();
        Self {
            degrees: vec![0; points.len()],
            points,
            ..Self::default()
        }
    }

    /// Takes a step forwards.
    ///
    /// # Errors
    /// If the event does not fit; the scene is then as it was.
    pub fn apply(&mut self, event: Event) -> Result<(), NoSuchStep> {
        self.change(event).map_err(|why| NoSuchStep { event, why })
    }

    /// Takes a step back.
    ///
    /// # Errors
    /// As [`apply`](Self::apply).
    pub fn revert(&mut self, event: Event) -> Result<(), NoSuchStep> {
        self.apply(event.reversed())
    }

    /// Returns where a vertex lies, if there is one of this number.
    pub fn point(&self, v: VertexId) -> Option<Point> {
        self.points.get(v.index()).copied()
    }

    /// Visits the vertices, with their positions.
    pub fn vertices(&self) -> impl Iterator<Item = (VertexId, Point)> + '_ {
        let numbered = self.points.iter().enumerate();
        numbered.map(|(i, &p)| (VertexId::new(i), p))
    }

    /// Visits the edges, smaller end first, sorted.
    pub fn edges(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        self.edges.iter().copied()
    }

    /// Tells whether an edge is a constraint.
    pub fn is_locked(&self, edge: [VertexId; 2]) -> bool {
        self.locked.contains(&ascending(edge))
    }

    /// Visits the triangles, counter-clockwise, smallest corner first, sorted.
    pub fn triangles(&self) -> impl Iterator<Item = [VertexId; 3]> + '_ {
        let corners = self.apexes.iter().map(|(&[a, b], &c)| [a, b, c]);
        corners.filter(|[a, b, c]| a < b && a < c)
    }

    /// Returns the corner opposite a directed edge, in the triangle to its left.
    pub fn apex(&self, edge: [VertexId; 2]) -> Option<VertexId> {
        self.apexes.get(&edge).copied()
    }

    /// Hashes the triangles, as [`Triangulation::hash`](crate::Triangulation::hash) does.
    pub fn hash(&self) -> TriangulationHash {
        let point = |v| self.point(v).expect("bug: a corner without position");
        hash_triangles(self.triangles().map(|t| t.map(point)))
    }

    /// Visits the vertices of the front, in their order.
    pub fn front(&self) -> impl Iterator<Item = VertexId> + '_ {
        let places = &self.front.places;
        let next = |place: &u32| places[place].after;
        std::iter::successors(self.front.first, next).map(|place| places[&place].vertex)
    }

    /// Returns where the sweep is, if there is one.
    pub fn sweep(&self) -> Option<Sweep> {
        self.sweep
    }

    /// Visits what waits in a queue, each as often as it waits.
    pub fn queue(&self, queue: Queue) -> impl Iterator<Item = Item> + '_ {
        let items = self.queues.get(&queue).into_iter().flatten();
        items.flat_map(|(&item, &times)| std::iter::repeat_n(item, times))
    }

    /// Returns the triangle that holds a datum.
    pub fn holder(&self, datum: VertexId) -> Option<[VertexId; 3]> {
        self.data.get(&datum).copied()
    }

    /// Visits the centers of the clusters, by number.
    pub fn clusters(&self) -> impl Iterator<Item = (u32, Point)> + '_ {
        self.clusters.iter().map(|(&number, &at)| (number, at))
    }

    /// Returns center and radius of the circle through three vertices, rounded, for drawing; `None` if
    /// they do not turn counter-clockwise.
    pub fn circle(&self, triangle: [VertexId; 3]) -> Option<(Point, f64)> {
        let [a, b, c] = triangle.map(|v| self.point(v));
        let [a, b, c] = [a?, b?, c?];
        if orient2d(a, b, c) != Orientation::Left {
            return None;
        }
        let center = circumcenter(a, b, c)?;
        Some((center, (a.x - center.x).hypot(a.y - center.y)))
    }

    fn change(&mut self, event: Event) -> Result<(), &'static str> {
        match event {
            Event::VertexCreated { vertex, at } => self.create_vertex(vertex, at),
            Event::VertexDeleted { vertex, at } => self.delete_vertex(vertex, at),
            Event::VertexMoved { vertex, from, to } => self.move_vertex(vertex, from, to),
            Event::EdgeCreated { edge } => self.create_edge(edge),
            Event::EdgeDeleted { edge } => self.delete_edge(edge),
            Event::EdgeLocked { edge } => self.lock(edge),
            Event::EdgeUnlocked { edge } => {
                require(self.locked.remove(&ascending(edge)), "is not locked")
            }
            Event::TriangleCreated { triangle } => self.create_triangle(triangle),
            Event::TriangleDeleted { triangle } => self.delete_triangle(triangle),
            Event::EdgeFlipped { from, to } => self.flip(from, to),
            Event::FrontEntered {
                place,
                vertex,
                after,
            } => self.front.enter(place, vertex, after),
            Event::FrontLeft {
                place,
                vertex,
                after,
            } => self.front.leave(place, vertex, after),
            Event::SweptTo { from, to } => {
                require(self.sweep == from, "the sweep is elsewhere")?;
                self.sweep = to;
                Ok(())
            }
            Event::Pushed { queue, item } => {
                *self
                    .queues
                    .entry(queue)
                    .or_default()
                    .entry(item)
                    .or_default() += 1;
                Ok(())
            }
            Event::Popped { queue, item } => self.pop(queue, item),
            Event::DatumReassigned { datum, from, to } => self.reassign(datum, from, to),
            Event::ClusterMoved { cluster, from, to } => self.move_cluster(cluster, from, to),
            _ => Ok(()),
        }
    }

    fn create_vertex(&mut self, v: VertexId, at: Point) -> Result<(), &'static str> {
        let is_next = v.index() == self.points.len();
        require(is_next, "its number is not the next that is free")?;
        self.points.push(at);
        self.degrees.push(0);
        Ok(())
    }

    fn delete_vertex(&mut self, v: VertexId, at: Point) -> Result<(), &'static str> {
        let is_last = v.index() + 1 == self.points.len();
        require(is_last, "it is not the last vertex")?;
        require(self.point(v) == Some(at), "it lies elsewhere")?;
        self.require_bare(v)?;
        self.points.pop();
        self.degrees.pop();
        Ok(())
    }

    fn move_vertex(&mut self, v: VertexId, from: Point, to: Point) -> Result<(), &'static str> {
        require(self.point(v) == Some(from), "it lies elsewhere")?;
        self.require_bare(v)?;
        self.points[v.index()] = to;
        Ok(())
    }

    fn require_bare(&self, v: VertexId) -> Result<(), &'static str> {
        require(self.degrees[v.index()] == 0, "an edge hangs on it")
    }

    fn create_edge(&mut self, edge: [VertexId; 2]) -> Result<(), &'static str> {
        let has_ends = edge.iter().all(|&v| self.point(v).is_some());
        require(has_ends && edge[0] != edge[1], "an end is missing")?;
        require(self.edges.insert(ascending(edge)), "there is such an edge")?;
        for v in edge {
            self.degrees[v.index()] += 1;
        }
        Ok(())
    }

    fn delete_edge(&mut self, [a, b]: [VertexId; 2]) -> Result<(), &'static str> {
        let sides = [[a, b], [b, a]];
        let is_bare = sides.iter().all(|edge| !self.apexes.contains_key(edge));
        require(is_bare, "it has a triangle")?;
        require(!self.is_locked([a, b]), "it is locked")?;
        require(
            self.edges.remove(&ascending([a, b])),
            "there is no such edge",
        )?;
        for v in [a, b] {
            self.degrees[v.index()] -= 1;
        }
        Ok(())
    }

    fn lock(&mut self, edge: [VertexId; 2]) -> Result<(), &'static str> {
        let edge = ascending(edge);
        require(self.edges.contains(&edge), "there is no such edge")?;
        require(self.locked.insert(edge), "it is locked")
    }

    fn create_triangle(&mut self, triangle: [VertexId; 3]) -> Result<(), &'static str> {
        let sides = corners(triangle);
        let has = |edge: &[VertexId; 2]| self.edges.contains(&ascending(*edge));
        require(
            sides.iter().all(|(edge, _)| has(edge)),
            "an edge is missing",
        )?;
        let is_free = sides
            .iter()
            .all(|(edge, _)| !self.apexes.contains_key(edge));
        require(is_free, "an edge has a triangle on this side")?;
        self.apexes.extend(sides);
        Ok(())
    }

    fn delete_triangle(&mut self, triangle: [VertexId; 3]) -> Result<(), &'static str> {
        let sides = corners(triangle);
        let is_there = sides
            .iter()
            .all(|&(edge, apex)| self.apex(edge) == Some(apex));
        require(is_there, "there is no such triangle")?;
        for (edge, _) in sides {
            self.apexes.remove(&edge);
        }
        Ok(())
    }

    fn flip(&mut self, from: [VertexId; 2], to: [VertexId; 2]) -> Result<(), &'static str> {
        let [a, b] = from;
        let (Some(c), Some(d)) = (self.apex([a, b]), self.apex([b, a])) else {
            return Err("a triangle is missing");
        };
        require(
            ascending([c, d]) == ascending(to),
            "these are not its apexes",
        )?;
        require(!self.is_locked(from), "it is locked")?;
        require(
            !self.edges.contains(&ascending(to)),
            "there is the other edge",
        )?;
        self.delete_triangle([a, b, c])?;
        self.delete_triangle([b, a, d])?;
        self.delete_edge(from)?;
        self.create_edge(to)?;
        self.create_triangle([c, d, b])?;
        self.create_triangle([d, c, a])
    }

    fn pop(&mut self, queue: Queue, item: Item) -> Result<(), &'static str> {
        let items = self.queues.get_mut(&queue).ok_or("nothing waits there")?;
        let times = items.get_mut(&item).ok_or("it does not wait")?;
        *times -= 1;
        if *times == 0 {
            items.remove(&item);
        }
        if items.is_empty() {
            self.queues.remove(&queue);
        }
        Ok(())
    }

    fn reassign(
        &mut self,
        datum: VertexId,
        from: Option<[VertexId; 3]>,
        to: Option<[VertexId; 3]>,
    ) -> Result<(), &'static str> {
        require(self.holder(datum) == from, "another triangle holds it")?;
        match to {
            Some(triangle) => self.data.insert(datum, triangle),
            None => self.data.remove(&datum),
        };
        Ok(())
    }

    fn move_cluster(
        &mut self,
        cluster: u32,
        from: Option<Point>,
        to: Option<Point>,
    ) -> Result<(), &'static str> {
        let center = self.clusters.get(&cluster).copied();
        require(center == from, "its center is elsewhere")?;
        match to {
            Some(at) => self.clusters.insert(cluster, at),
            None => self.clusters.remove(&cluster),
        };
        Ok(())
    }
}

impl Front {
    fn enter(
        &mut self,
        place: u32,
        vertex: VertexId,
        before: Option<u32>,
    ) -> Result<(), &'static str> {
        require(!self.places.contains_key(&place), "there is such a place")?;
        let after = match before {
            Some(before) => {
                self.places
                    .get(&before)
                    .ok_or("the place before is missing")?
                    .after
            }
            None => self.first,
        };
        let new = Place {
            vertex,
            before,
            after,
        };
        self.places.insert(place, new);
        self.link(before, Some(place));
        self.link(Some(place), after);
        Ok(())
    }

    fn leave(
        &mut self,
        place: u32,
        vertex: VertexId,
        before: Option<u32>,
    ) -> Result<(), &'static str> {
        let old = *self.places.get(&place).ok_or("there is no such place")?;
        require(old.vertex == vertex, "it is another vertex")?;
        require(old.before == before, "another place is before it")?;
        self.places.remove(&place);
        self.link(before, old.after);
        Ok(())
    }

    fn link(&mut self, before: Option<u32>, after: Option<u32>) {
        match before {
            Some(before) => self.places.get_mut(&before).expect("bug: no place").after = after,
            None => self.first = after,
        }
        if let Some(after) = after {
            self.places.get_mut(&after).expect("bug: no place").before = before;
        }
    }
}

fn require(holds: bool, why: &'static str) -> Result<(), &'static str> {
    if holds { Ok(()) } else { Err(why) }
}

/// Each side, and the corner opposite to it.
fn corners([a, b, c]: [VertexId; 3]) -> [([VertexId; 2], VertexId); 3] {
    [([a, b], c), ([b, c], a), ([c, a], b)]
}
