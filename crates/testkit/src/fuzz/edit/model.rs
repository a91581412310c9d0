//! What edits must do, without a triangulation: which points and constraints there are, and what is
//! refused.

use delone::edit::{ConstraintId, EditError, Inserted, LiveTriangulation};
use delone::predicates::{cross_properly, is_between};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, HalfEdgeId, Mesh, Point, Pslg, VertexId,
};
use std::collections::{BTreeMap, BTreeSet};

/// Points and constraints, and nothing of a triangulation.
#[derive(Clone, Debug, Default)]
pub(super) struct Model {
    points: BTreeMap<VertexId, Point>,
    constraints: BTreeMap<ConstraintId, [VertexId; 2]>,
}

impl Model {
    pub fn new(start: &[Point]) -> Self {
        let mut model = Self::default();
        for (i, &p) in start.iter().enumerate() {
            if model.at(p).is_none() {
                model.points.insert(VertexId::new(i), p);
            }
        }
        model
    }

    fn at(&self, p: Point) -> Option<VertexId> {
        let mut points = self.points.iter();
        points.find(|&(_, &q)| p == q).map(|(&v, _)| v)
    }

    fn vertex(&self, k: usize) -> Option<VertexId> {
        self.points
            .keys()
            .nth(k % self.points.len().max(1))
            .copied()
    }

    fn segment(&self, ends: [VertexId; 2]) -> [Point; 2] {
        ends.map(|v| self.points[&v])
    }

    /// Tells whether two constraints would cross elsewhere than in a vertex.
    fn cross(&self, one: [VertexId; 2], other: [VertexId; 2]) -> bool {
        let [one, other] = [one, other].map(|ends| self.segment(ends));
        let on = |s: [Point; 2], p: Point| is_between(s[0], s[1], p);
        let mut points = self.points.values();
        cross_properly(one, other) && !points.any(|&p| on(one, p) && on(other, p))
    }

    fn is_planar(&self) -> bool {
        let all: Vec<_> = self.constraints.values().collect();
        let mut pairs = (0..all.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        !pairs.any(|(i, j)| self.cross(*all[i], *all[j]))
    }

    pub fn insert(&mut self, live: &mut LiveTriangulation, p: Point) -> Result<(), String> {
        match (live.insert(p), self.at(p)) {
            (Err(EditError::NotFinite { .. }), None) if !p.is_finite() => Ok(()),
            (Ok(Inserted::Duplicate(v)), Some(there)) if v == there => Ok(()),
            (Ok(Inserted::Vertex(v)), None) if !self.points.contains_key(&v) => {
                self.points.insert(v, p);
                Ok(())
            }
            (other, _) => Err(format!("insertion of {p:?}: {other:?}")),
        }
    }

    pub fn remove(&mut self, live: &mut LiveTriangulation, k: usize) -> Result<(), String> {
        let Some(v) = self.vertex(k) else {
            return match live.remove(VertexId::new(k)) {
                Err(EditError::NoVertex { .. }) => Ok(()),
                other => Err(format!("removal from nothing: {other:?}")),
            };
        };
        let mut constraints = self.constraints.iter();
        let ending = constraints.find(|(_, ends)| ends.contains(&v));
        let outcome = live.remove(v);
        if let Some((&constraint, _)) = ending {
            let expected = EditError::IsEnd {
                vertex: v,
                constraint,
            };
            return expect(outcome == Err(expected), "removal of an end", &outcome);
        }
        let mut without = self.clone();
        let point = without.points.remove(&v).expect("a vertex of the model");
        if !without.is_planar() {
            let is_crossroads =
                matches!(outcome, Err(EditError::Crossroads { vertex, .. }) if vertex == v);
            return expect(is_crossroads, "removal of a crossing", &outcome);
        }
        *self = without;
        expect(outcome == Ok(point), "removal", &outcome)
    }

    pub fn move_to(
        &mut self,
        live: &mut LiveTriangulation,
        k: usize,
        p: Point,
    ) -> Result<(), String> {
        let Some(v) = self.vertex(k) else {
            return Ok(());
        };
        let outcome = live.move_to(v, p);
        if !p.is_finite() {
            let is_refused = matches!(outcome, Err(EditError::NotFinite { .. }));
            return expect(is_refused, "move to nowhere", &outcome);
        }
        if let Some(vertex) = self.at(p).filter(|&there| there != v) {
            let at = p;
            let expected = Err(EditError::Occupied { vertex, at });
            return expect(outcome == expected, "move onto a vertex", &outcome);
        }
        let mut moved = self.clone();
        moved.points.insert(v, p);
        if !moved.is_planar() {
            let is_refused = match outcome {
                Err(EditError::Crossroads { vertex, .. }) => vertex == v,
                Err(EditError::Crossing { ends, crossed, .. }) => {
                    ends.contains(&v) && moved.cross(ends, self.constraints[&crossed])
                }
                _ => false,
            };
            return expect(is_refused, "move across a constraint", &outcome);
        }
        // Without the vertex, on the way, constraints may cross that do not with it where it was or is.
        *self = moved;
        expect(outcome == Ok(()), "move", &outcome)
    }

    pub fn constrain(
        &mut self,
        live: &mut LiveTriangulation,
        k: usize,
        l: usize,
    ) -> Result<(), String> {
        let (Some(a), Some(b)) = (self.vertex(k), self.vertex(l)) else {
            return Ok(());
        };
        let ends = [a, b];
        let crossed = |other: [VertexId; 2]| self.cross(ends, other);
        match live.add_constraint(a, b) {
            Err(EditError::NoLength { vertex }) if a == b && a == vertex => Ok(()),
            Err(EditError::Crossing {
                ends: named,
                crossed: other,
                ..
            }) if a != b && named == ends && crossed(self.constraints[&other]) => Ok(()),
            Ok(id) if a != b && !self.constraints.values().any(|&other| crossed(other)) => {
                let is_new = self.constraints.insert(id, ends).is_none();
                expect(is_new, "constraint", &id)
            }
            other => Err(format!("constraint from {a:?} to {b:?}: {other:?}")),
        }
    }

    pub fn release(&mut self, live: &mut LiveTriangulation, k: usize) -> Result<(), String> {
        let mut ids = self.constraints.keys();
        let Some(&id) = ids.nth(k % self.constraints.len().max(1)) else {
            return Ok(());
        };
        let outcome = live.remove_constraint(id);
        let ends = self.constraints.remove(&id);
        expect(outcome.ok() == ends, "release", &outcome)
    }

    /// Requires that the live triangulation holds what the model does, and is what would be made of
    /// that from scratch.
    pub fn compare(&self, live: &LiveTriangulation) -> Result<(), String> {
        let vertices = live.vertices().map(|v| (v, live.point(v)));
        let points = self.points.iter().map(|(&v, &p)| (v, Some(p)));
        expect(vertices.eq(points), "the vertices", &"are others")?;
        let ids = live.constraints().map(|id| (id, live.constraint(id)));
        let constraints = self.constraints.iter().map(|(&id, &ends)| (id, Some(ends)));
        expect(ids.eq(constraints), "the constraints", &"are others")?;
        live.mesh().validate().map_err(|e| e.to_string())?;
        let fresh = self.made_anew()?;
        let t = fresh.triangulation();
        let faces = [live.mesh(), t.mesh()].map(Mesh::num_faces);
        expect(faces[0] == faces[1], "the number of faces", &faces)?;
        expect(live.hash() == t.hash(), "the triangles", &"are others")?;
        compare_edges(live, &fresh)?;
        self.compare_chains(live, &fresh)?;
        compare_stars(live)
    }

    fn made_anew(&self) -> Result<ConstrainedTriangulation, String> {
        let names: Vec<_> = self.points.keys().copied().collect();
        let mut pslg = Pslg::from_points(self.points.values().copied());
        for &ends in self.constraints.values() {
            let place = |v: VertexId| names.binary_search(&v).expect("a vertex of the model");
            let [a, b] = ends.map(place);
            pslg.segments.push([a, b].map(VertexId::new));
        }
        let fresh = ConstrainedDelaunay::new().threads(1).triangulate(pslg);
        fresh.map_err(|e| e.to_string())
    }

    /// The chains must be the same, and the edges along them know it.
    fn compare_chains(
        &self,
        live: &LiveTriangulation,
        fresh: &ConstrainedTriangulation,
    ) -> Result<(), String> {
        let names: Vec<_> = self.points.keys().copied().collect();
        let mut along = BTreeSet::new();
        for (i, &id) in self.constraints.keys().enumerate() {
            let expected: Vec<_> = fresh.chain(i).iter().map(|v| names[v.index()]).collect();
            let chain = live.chain(id).unwrap_or_default();
            expect(chain == expected, "a chain", &(&chain, &expected))?;
            along.extend(
                chain
                    .windows(2)
                    .map(|pair| (pair[0].min(pair[1]), pair[0].max(pair[1]), id)),
            );
        }
        let mut found = BTreeSet::new();
        for h in live.mesh().half_edges() {
            let [a, b] = [live.mesh().origin(h), live.mesh().dest(h)];
            found.extend(live.constraints_along(h).map(|id| (a.min(b), a.max(b), id)));
        }
        expect(found == along, "the constraints along edges", &"are others")
    }
}

fn expect(holds: bool, what: &str, found: &dyn std::fmt::Debug) -> Result<(), String> {
    if holds {
        Ok(())
    } else {
        Err(format!("{what}: {found:?}"))
    }
}

/// The edges must be the same, which matters if there are no triangles, and the same ones constrained.
fn compare_edges(live: &LiveTriangulation, fresh: &ConstrainedTriangulation) -> Result<(), String> {
    let live_point = |v: VertexId| live.point(v).unwrap_or_default();
    let mine = edges(live.mesh(), live_point, |h| live.is_constrained(h));
    let t = fresh.triangulation();
    let theirs = edges(t.mesh(), |v| t.point(v), |h| fresh.is_constrained(h));
    expect(mine == theirs, "the edges", &"are others")
}

/// Lists the half-edges between finite vertices, by coordinates, and whether each is constrained.
fn edges(
    mesh: &Mesh,
    point: impl Fn(VertexId) -> Point,
    is_constrained: impl Fn(HalfEdgeId) -> bool,
) -> Vec<([u64; 4], bool)> {
    let ends = |h| [mesh.origin(h), mesh.dest(h)];
    let finite = mesh
        .half_edges()
        .filter(|&h| !ends(h).iter().any(|v| v.is_infinite()));
    let mut edges: Vec<_> = finite
        .map(|h| {
            let [p, q] = ends(h).map(&point);
            let bits = [p.x, p.y, q.x, q.y].map(|c| (c + 0.0).to_bits());
            (bits, is_constrained(h))
        })
        .collect();
    edges.sort_unstable();
    edges
}

/// Every vertex knows its star, if there are two.
fn compare_stars(live: &LiveTriangulation) -> Result<(), String> {
    let mut degrees: BTreeMap<VertexId, usize> = BTreeMap::new();
    for h in live.mesh().half_edges() {
        *degrees.entry(live.mesh().origin(h)).or_default() += 1;
    }
    for v in live.vertices() {
        let star: Vec<_> = live.star(v).collect();
        let is_whole = star.len() == degrees.get(&v).copied().unwrap_or(0);
        let starts_here = star.iter().all(|&h| live.mesh().origin(h) == v);
        expect(is_whole && starts_here, "a star", &v)?;
    }
    Ok(())
}
