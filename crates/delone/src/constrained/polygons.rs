//! The union of polygons, each by the parity of its own segments.
//!
//! The segments of all polygons divide the plane into components. A depth-first search through them
//! keeps the set of polygons around the present one: crossing an edge toggles the polygons whose
//! segments run along it an odd number of times. As every polygon is closed, the way there does not
//! matter. *Cost*: O((n + m) log m) for m segments of polygons.

use super::draft::Draft;
use super::segments::{Segments, undirected};
use super::witness::{Witness, tell_reached};
use crate::pace::Pace;
use crate::{Error, HalfEdgeId, VertexId};

/// Marks the faces outside of all polygons.
pub(super) fn outside_union(
    draft: &Draft,
    segments: &Segments,
    pace: &mut Pace,
    witness: impl Witness,
) -> Result<Vec<bool>, Error> {
    if draft.mesh.num_faces() == 0 {
        return Ok(Vec::new());
    }
    let borders = Borders::of(segments);
    let components = Components::find(draft, &borders, pace, witness)?;
    let outside = components.outside_of(&borders, segments.polygons.len());
    let faces = components.of_face.iter();
    Ok(faces.map(|&c| outside[c as usize]).collect())
}

/// The edges that some polygon counts an odd number of times, sorted, with those polygons.
struct Borders(Vec<([VertexId; 2], u32)>);

impl Borders {
    fn of(segments: &Segments) -> Self {
        let mut uses = Vec::new();
        for (polygon, range) in (0..).zip(segments.polygons) {
            let edges = range.clone().flat_map(|segment| segments.edges(segment));
            uses.extend(edges.map(|edge| (edge, polygon)));
        }
        uses.sort_unstable();
        let odd = uses
            .chunk_by(|a, b| a == b)
            .filter(|run| run.len() % 2 == 1);
        Self(odd.map(|run| run[0]).collect())
    }

    /// The entries of an edge, as a range of indices.
    fn of_edge(&self, draft: &Draft, h: HalfEdgeId) -> std::ops::Range<usize> {
        if !draft.marks.is_constrained(h) {
            return 0..0;
        }
        let edge = undirected([draft.mesh.origin(h), draft.mesh.dest(h)]);
        let start = self.0.partition_point(|(e, _)| *e < edge);
        let len = self.0[start..]
            .iter()
            .take_while(|(e, _)| *e == edge)
            .count();
        start..start + len
    }
}

/// A border seen from one of the two components beside it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Gate {
    from: u32,
    to: u32,
    /// The entries of its edge.
    start: u32,
    end: u32,
}

/// The components into which borders divide the faces; the ghosts are in component 0.
struct Components {
    of_face: Vec<u32>,
    /// Sorted by the component they lead from.
    gates: Vec<Gate>,
    number: usize,
}

impl Components {
    fn find(
        draft: &Draft,
        borders: &Borders,
        pace: &mut Pace,
        witness: impl Witness,
    ) -> Result<Self, Error> {
        const NONE: u32 = u32::MAX;
        let mesh = &draft.mesh;
        let mut of_face = vec![NONE; mesh.num_faces()];
        let mut number = 0;
        let mut stack = Vec::new();
        let mut rims = Vec::new();
        for start in mesh.ghosts().chain(mesh.triangles()) {
            if of_face[start.index()] != NONE {
                continue;
            }
            of_face[start.index()] = number;
            stack.push(start);
            while let Some(t) = stack.pop() {
                pace.step()?;
                tell_reached(witness, draft, t);
                for h in t.half_edges() {
                    let entries = borders.of_edge(draft, h);
                    let neighbor = mesh.twin(h).triangle();
                    if !entries.is_empty() {
                        rims.push((h, entries));
                    } else if of_face[neighbor.index()] == NONE {
                        of_face[neighbor.index()] = number;
                        stack.push(neighbor);
                    }
                }
            }
            number += 1;
        }
        let component = |h: HalfEdgeId| of_face[h.triangle().index()];
        let gates = rims.into_iter().map(|(h, entries)| Gate {
            from: component(h),
            to: component(mesh.twin(h)),
            start: entries.start as u32,
            end: entries.end as u32,
        });
        let mut gates: Vec<_> = gates.collect();
        gates.sort_unstable();
        Ok(Self {
            of_face,
            gates,
            number: number as usize,
        })
    }

    /// Tells of each component whether it lies outside of all polygons.
    fn outside_of(&self, borders: &Borders, polygons: usize) -> Vec<bool> {
        let first_gate = |component: u32| self.gates.partition_point(|gate| gate.from < component);
        let mut around = Around::new(polygons);
        let mut outside = vec![None; self.number];
        outside[0] = Some(true);
        // The way to the present component: the gates passed, and the next gate to try in each.
        let mut way: Vec<(Option<Gate>, usize)> = vec![(None, 0)];
        while let Some((entrance, next)) = way.last_mut() {
            let here = entrance.map_or(0, |gate| gate.to);
            match self.gates.get(*next).filter(|gate| gate.from == here) {
                Some(&gate) => {
                    *next += 1;
                    if outside[gate.to as usize].is_none() {
                        around.toggle(borders, gate);
                        outside[gate.to as usize] = Some(around.number == 0);
                        way.push((Some(gate), first_gate(gate.to)));
                    }
                }
                None => {
                    if let Some(gate) = *entrance {
                        around.toggle(borders, gate);
                    }
                    way.pop();
                }
            }
        }
        let known = outside.into_iter();
        known
            .map(|o| o.expect("bug: every component is reached"))
            .collect()
    }
}

/// The polygons around the present component.
struct Around {
    is_inside: Vec<bool>,
    number: usize,
}

impl Around {
    fn new(polygons: usize) -> Self {
        Self {
            is_inside: vec![false; polygons],
            number: 0,
        }
    }

    fn toggle(&mut self, borders: &Borders, gate: Gate) {
        for &(_, polygon) in &borders.0[gate.start as usize..gate.end as usize] {
            let is_inside = &mut self.is_inside[polygon as usize];
            *is_inside = !*is_inside;
            if *is_inside {
                self.number += 1;
            } else {
                self.number -= 1;
            }
        }
    }
}
