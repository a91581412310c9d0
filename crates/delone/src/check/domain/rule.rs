//! Which faces belong to the domain: the rules, read literally.

use super::chains::Chains;
use super::faces::{Face, Faces, OUTER};
use super::graph::{Dart, Graph};
use crate::pace::Pace;
use crate::{DomainRule, Error, Pslg};
use std::collections::VecDeque;

/// Tells for every face whether the rule takes it in, holes by seed not counted.
///
/// Under [`DomainRule::Hull`] the edges of the hull belong to the graph: so this and
/// [`DomainRule::Carve`] both take whatever is closed off from the outer face.
pub(super) fn take(
    input: &Pslg,
    rule: DomainRule,
    graph: &Graph,
    faces: &Faces,
    chains: &Chains,
    pace: &mut Pace,
) -> Result<Vec<bool>, Error> {
    match rule {
        DomainRule::Hull | DomainRule::Carve => {
            let mut belongs = vec![true; faces.count()];
            belongs[OUTER as usize] = false;
            Ok(belongs)
        }
        DomainRule::EvenOdd => {
            let sides = Sides::new(graph, faces, pace)?;
            if input.polygons.is_empty() {
                odd_depths(&sides, chains, pace)
            } else {
                in_odd_polygons(input, &sides, chains, pace)
            }
        }
    }
}

/// The darts that have each face to their left.
struct Sides<'a> {
    graph: &'a Graph<'a>,
    faces: &'a Faces,
    starts: Vec<u32>,
    darts: Vec<Dart>,
}

impl<'a> Sides<'a> {
    fn new(graph: &'a Graph, faces: &'a Faces, pace: &mut Pace) -> Result<Self, Error> {
        let mut starts = vec![0; faces.count() + 1];
        for dart in graph.darts() {
            pace.step()?;
            starts[faces.left(dart) as usize + 1] += 1;
        }
        for face in 1..starts.len() {
            starts[face] += starts[face - 1];
        }
        let mut next = starts.clone();
        let mut darts = vec![Dart::rightward(0); graph.num_darts()];
        for dart in graph.darts() {
            pace.step()?;
            let slot = &mut next[faces.left(dart) as usize];
            darts[*slot as usize] = dart;
            *slot += 1;
        }
        Ok(Self {
            graph,
            faces,
            starts,
            darts,
        })
    }

    fn of(&self, face: Face) -> &[Dart] {
        let [first, end] = [0, 1].map(|i| self.starts[face as usize + i] as usize);
        &self.darts[first..end]
    }

    /// Returns the face on the other side of a dart.
    fn beyond(&self, dart: Dart) -> Face {
        self.faces.left(dart.twin())
    }
}

/// Tells which faces lie behind an odd number of segments, counted along the way from outside that
/// crosses fewest; an edge counts 1 if it is part of an odd number of segments, else 0.
///
/// Faces are visited by their depth: those behind an edge that does not count come before the rest.
fn odd_depths(sides: &Sides, chains: &Chains, pace: &mut Pace) -> Result<Vec<bool>, Error> {
    let mut counts = vec![false; sides.graph.edges().len()];
    for chain in chains.iter() {
        for dart in chain {
            pace.step()?;
            counts[dart.edge()] ^= true;
        }
    }
    let mut depths = vec![None; sides.faces.count()];
    let mut ahead = VecDeque::from([(OUTER, 0)]);
    while let Some((face, depth)) = ahead.pop_front() {
        if depths[face as usize].is_some() {
            continue;
        }
        depths[face as usize] = Some(depth);
        for &dart in sides.of(face) {
            pace.step()?;
            let beyond = sides.beyond(dart);
            if counts[dart.edge()] {
                ahead.push_back((beyond, depth + 1));
            } else {
                ahead.push_front((beyond, depth));
            }
        }
    }
    let is_odd = |depth: Option<u32>| depth.is_some_and(|d| d % 2 == 1);
    Ok(depths.into_iter().map(is_odd).collect())
}

/// Tells which faces lie in a polygon, each by its own parity.
///
/// Polygons are closed, so the parity does not depend on the way: faces are visited along any tree,
/// entering and leaving polygons forth and back.
fn in_odd_polygons(
    input: &Pslg,
    sides: &Sides,
    chains: &Chains,
    pace: &mut Pace,
) -> Result<Vec<bool>, Error> {
    let owners = Owners::find(input, sides.graph, chains, pace)?;
    let mut belongs = vec![false; sides.faces.count()];
    let mut seen = vec![false; sides.faces.count()];
    let mut around = Around {
        is_inside: vec![false; input.polygons.len()],
        count: 0,
    };
    let mut path = vec![(None, sides.of(OUTER).iter())];
    seen[OUTER as usize] = true;
    while let Some((entered, darts)) = path.last_mut() {
        pace.step()?;
        let Some(&dart) = darts.next() else {
            around.cross(entered.map_or(&[], |dart| owners.of(dart)), pace)?;
            path.pop();
            continue;
        };
        let face = sides.beyond(dart);
        if !std::mem::replace(&mut seen[face as usize], true) {
            around.cross(owners.of(dart), pace)?;
            belongs[face as usize] = around.count > 0;
            path.push((Some(dart), sides.of(face).iter()));
        }
    }
    Ok(belongs)
}

/// The polygons around the face at hand.
struct Around {
    is_inside: Vec<bool>,
    count: usize,
}

impl Around {
    /// Enters the polygons that are left, and leaves the others.
    fn cross(&mut self, polygons: &[u32], pace: &mut Pace) -> Result<(), Error> {
        for &polygon in polygons {
            pace.step()?;
            let is_inside = &mut self.is_inside[polygon as usize];
            *is_inside = !*is_inside;
            if *is_inside {
                self.count += 1;
            } else {
                self.count -= 1;
            }
        }
        Ok(())
    }
}

/// For each edge the polygons that it bounds, as often as they use it.
struct Owners {
    starts: Vec<usize>,
    polygons: Vec<u32>,
}

impl Owners {
    fn find(input: &Pslg, graph: &Graph, chains: &Chains, pace: &mut Pace) -> Result<Self, Error> {
        let mut starts = vec![0; graph.edges().len() + 1];
        visit_polygon_edges(input, chains, pace, |edge, _| starts[edge + 1] += 1)?;
        for edge in 1..starts.len() {
            starts[edge] += starts[edge - 1];
        }
        let mut next = starts.clone();
        let mut polygons = vec![0; starts[starts.len() - 1]];
        visit_polygon_edges(input, chains, pace, |edge, polygon| {
            polygons[next[edge]] = polygon;
            next[edge] += 1;
        })?;
        Ok(Self { starts, polygons })
    }

    fn of(&self, dart: Dart) -> &[u32] {
        &self.polygons[self.starts[dart.edge()]..self.starts[dart.edge() + 1]]
    }
}

fn visit_polygon_edges(
    input: &Pslg,
    chains: &Chains,
    pace: &mut Pace,
    mut visit: impl FnMut(usize, u32),
) -> Result<(), Error> {
    for (polygon, segments) in input.polygons.iter().enumerate() {
        for segment in segments.clone() {
            for dart in chains.of(segment) {
                pace.step()?;
                visit(dart.edge(), polygon as u32);
            }
        }
    }
    Ok(())
}
