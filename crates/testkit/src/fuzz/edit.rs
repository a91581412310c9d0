//! Random sequences of edits, each compared with a triangulation made from scratch, and with a model
//! that knows which edits must be refused.

use super::points::{kind, points_from_bytes};
use super::{Case, guarded, without_one};
use crate::generate::Random;
use delone::edit::{ConstraintId, EditError, Inserted, LiveTriangulation};
use delone::predicates::{cross_properly, is_between};
use delone::{ConstrainedDelaunay, ConstrainedTriangulation, Point, Pslg, VertexId};
use std::collections::{BTreeMap, BTreeSet};

/// One edit. Vertices and constraints are named by any number, modulo how many there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit {
    /// Inserts a point.
    Insert(Point),
    /// Removes a vertex.
    Remove(usize),
    /// Moves a vertex.
    Move(usize, Point),
    /// Constrains the segment between two vertices.
    Constrain(usize, usize),
    /// Removes a constraint.
    Release(usize),
    /// Does the following edits, so many of them, in a transaction, which fails in the end or does not.
    Together(usize, bool),
}

/// What is to be edited, and how.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// The points to begin with, triangulated in bulk.
    pub start: Vec<Point>,
    /// The edits, one after the other.
    pub edits: Vec<Edit>,
}

/// Fills `script` with the case that `seed` names, with at most so many points to begin with, and at
/// most so many edits.
pub fn case(seed: u64, max_points: usize, max_edits: usize, script: &mut Script) {
    let r = &mut Random::new(seed);
    let kind = kind(r);
    let start = r.below(max_points + 1);
    kind.fill(&mut script.start, start, r);
    let edits = 1 + r.below(max_edits);
    let mut points = Vec::new();
    kind.fill(&mut points, edits, r);
    // Some sequences grow, some shrink, some are all about constraints.
    let style = r.below(4);
    script.edits.clear();
    script
        .edits
        .extend(points.into_iter().map(|p| edit(style, p, r)));
}

fn edit(style: usize, p: Point, r: &mut Random) -> Edit {
    let [a, b] = [0; 2].map(|_| r.below(1 << 16));
    // Insert, remove, move, constrain, release, together.
    const WEIGHTS: [[usize; 6]; 4] = [
        [5, 3, 4, 0, 0, 1],
        [3, 6, 2, 2, 1, 1],
        [5, 2, 4, 6, 2, 1],
        [2, 2, 6, 6, 3, 2],
    ];
    let weights = WEIGHTS[style];
    let mut drawn = r.below(weights.iter().sum());
    let mut which = 0;
    while drawn >= weights[which] {
        drawn -= weights[which];
        which += 1;
    }
    match which {
        0 => Edit::Insert(p),
        1 => Edit::Remove(a),
        2 => Edit::Move(a, p),
        3 => Edit::Constrain(a, b),
        4 => Edit::Release(a),
        _ => Edit::Together(1 + a % 6, b % 2 == 0),
    }
}

/// Reads a script from a fuzzer's bytes: how many edits, three bytes each, and then
/// [points](points_from_bytes), those of the edits before those to begin with.
pub fn script_from_bytes(bytes: &[u8]) -> Script {
    let Some((&count, rest)) = bytes.split_first() else {
        return Script::default();
    };
    let count = usize::from(count).min(rest.len() / 3);
    let (edits, rest) = rest.split_at(3 * count);
    let mut points = points_from_bytes(rest).into_iter();
    let edits = edits.chunks_exact(3).map(|bytes| {
        let [a, b] = [bytes[1], bytes[2]].map(usize::from);
        let mut point = || points.next().unwrap_or_default();
        match bytes[0] % 16 {
            0..5 => Edit::Insert(point()),
            5..8 => Edit::Remove(a),
            8..11 => Edit::Move(a, point()),
            11..14 => Edit::Constrain(a, b),
            14 => Edit::Release(a),
            _ => Edit::Together(1 + a % 8, b % 2 == 0),
        }
    });
    Script {
        edits: edits.collect(),
        start: points.filter(Point::is_finite).collect(),
    }
}

/// Does the edits, and checks everything after each; a panic is a failure too.
///
/// # Errors
/// What went wrong.
pub fn check(script: &Script) -> Result<(), String> {
    guarded(|| check_edits(script))
}

fn check_edits(script: &Script) -> Result<(), String> {
    let t = delone::Delaunay::new().threads(1);
    let t = t.triangulate(script.start.iter().copied());
    let mut live = LiveTriangulation::from_triangulation(&t.map_err(|e| e.to_string())?);
    let mut model = Model::new(&script.start);
    model.compare(&live)?;
    let mut left = &script.edits[..];
    while let Some((&edit, rest)) = left.split_first() {
        left = rest;
        match edit {
            Edit::Together(count, fails) => {
                let (these, rest) = rest.split_at(count.min(rest.len()));
                left = rest;
                together(&mut live, &mut model, these, fails)?;
            }
            edit => single(&mut live, &mut model, edit)?,
        }
        let in_words = |reason| format!("{reason}, with {} edits left", left.len());
        model.compare(&live).map_err(in_words)?;
    }
    Ok(())
}

/// Does an edit, but for transactions, which are not nested here.
fn single(live: &mut LiveTriangulation, model: &mut Model, edit: Edit) -> Result<(), String> {
    match edit {
        Edit::Insert(p) => model.insert(live, p),
        Edit::Remove(k) => model.remove(live, k),
        Edit::Move(k, p) => model.move_to(live, k, p),
        Edit::Constrain(k, l) => model.constrain(live, k, l),
        Edit::Release(k) => model.release(live, k),
        Edit::Together(..) => Ok(()),
    }
}

/// Does edits in a transaction. If it fails, nothing may have changed, not even the ids to come.
fn together(
    live: &mut LiveTriangulation,
    model: &mut Model,
    edits: &[Edit],
    fails: bool,
) -> Result<(), String> {
    let (mut twin, mut changed) = (live.clone(), model.clone());
    let mut outcome = Ok(());
    let ended = live.transaction(|live| {
        outcome = edits
            .iter()
            .try_for_each(|&edit| single(live, &mut changed, edit));
        if fails { Err(()) } else { Ok(()) }
    });
    outcome?;
    if ended.is_err() != fails {
        return Err("a transaction has another outcome than its edits".to_owned());
    }
    if !fails {
        *model = changed;
        return Ok(());
    }
    model.compare(live)?;
    let mut again = live.clone();
    let ids = |live: &mut LiveTriangulation| {
        let mut model = model.clone();
        let outcomes = edits.iter().map(|&edit| {
            let _ = single(live, &mut model, edit);
            let vertices: Vec<_> = live.vertices().collect();
            (vertices, live.constraints().collect::<Vec<_>>())
        });
        outcomes.collect::<Vec<_>>()
    };
    if ids(&mut twin) == ids(&mut again) {
        Ok(())
    } else {
        Err("ids after a transaction that failed are others".to_owned())
    }
}

/// Points and constraints, and nothing of a triangulation.
#[derive(Clone, Debug, Default)]
struct Model {
    points: BTreeMap<VertexId, Point>,
    constraints: BTreeMap<ConstraintId, [VertexId; 2]>,
}

impl Model {
    fn new(start: &[Point]) -> Self {
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

    fn insert(&mut self, live: &mut LiveTriangulation, p: Point) -> Result<(), String> {
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

    fn remove(&mut self, live: &mut LiveTriangulation, k: usize) -> Result<(), String> {
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

    fn move_to(&mut self, live: &mut LiveTriangulation, k: usize, p: Point) -> Result<(), String> {
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

    fn constrain(
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

    fn release(&mut self, live: &mut LiveTriangulation, k: usize) -> Result<(), String> {
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
    fn compare(&self, live: &LiveTriangulation) -> Result<(), String> {
        let vertices = live.vertices().map(|v| (v, live.point(v)));
        let points = self.points.iter().map(|(&v, &p)| (v, Some(p)));
        expect(vertices.eq(points), "the vertices", &"are others")?;
        let ids = live.constraints().map(|id| (id, live.constraint(id)));
        let constraints = self.constraints.iter().map(|(&id, &ends)| (id, Some(ends)));
        expect(ids.eq(constraints), "the constraints", &"are others")?;
        live.mesh().validate().map_err(|e| e.to_string())?;
        let fresh = self.made_anew()?;
        let t = fresh.triangulation();
        let faces = [live.mesh(), t.mesh()].map(delone::Mesh::num_faces);
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
    mesh: &delone::Mesh,
    point: impl Fn(VertexId) -> Point,
    is_constrained: impl Fn(delone::HalfEdgeId) -> bool,
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

impl Case for Script {
    fn smaller(&self) -> Vec<Self> {
        let fewer_edits = without_one(&self.edits).map(|edits| Self {
            edits,
            start: self.start.clone(),
        });
        let fewer_points = without_one(&self.start).map(|start| Self {
            start,
            edits: self.edits.clone(),
        });
        fewer_edits.chain(fewer_points).collect()
    }

    fn as_source(&self) -> String {
        let mut source = format!(
            "let start = {};\nlet edits = [\n",
            super::array(&self.start)
        );
        for edit in &self.edits {
            let edit = match edit {
                Edit::Insert(p) => format!("Insert(Point::new({:?}, {:?}))", p.x, p.y),
                Edit::Move(k, p) => format!("Move({k}, Point::new({:?}, {:?}))", p.x, p.y),
                other => format!("{other:?}"),
            };
            source += &format!("    Edit::{edit},\n");
        }
        source + "];"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn script(seed: u64) -> Script {
        let mut script = Script::default();
        case(seed, 12, 30, &mut script);
        script
    }

    #[test]
    fn cases_are_named_by_their_seeds_and_pass() {
        for seed in 0..1000 {
            let found = script(seed);
            assert_eq!(found, script(seed));
            let outcome = check(&found);
            assert_eq!(outcome, Ok(()), "seed {seed}\n{}", found.as_source());
        }
    }

    #[test]
    fn bytes_become_scripts() {
        assert_eq!(script_from_bytes(&[]), Script::default());
        let bytes = [3, 0, 9, 9, 11, 1, 2, 15, 3, 4, 9, 1, 2, 3, 0];
        let found = script_from_bytes(&bytes);
        let points = [(1.0, 2.0), (3.0, 0.0)].map(Point::from);
        let edits = [
            Edit::Insert(points[0]),
            Edit::Constrain(1, 2),
            Edit::Together(4, true),
        ];
        assert_eq!(
            (&found.edits[..], &found.start[..]),
            (&edits[..], &points[1..])
        );
        assert_eq!(check(&found), Ok(()));
    }

    #[test]
    fn source_is_exact() {
        let script = Script {
            start: Vec::new(),
            edits: vec![Edit::Move(3, Point::new(0.1 + 0.2, 5e-324))],
        };
        let source = script.as_source();
        assert!(source.contains("Edit::Move(3, Point::new(0.30000000000000004, 5e-324)),"));
    }
}
