//! Is a table of lineage that of a mesh? From the input, points and constrained edges.
//!
//! The chains that the rows of edges make are what the verifier is given as claims; it proves that they are there
//! and how near to their segments they lie. What is tested here is that rows, chains and places agree, and that free
//! vertices have the weights of the triangles of the input's triangulation, which is made anew from the chains.

use super::within::places;
use super::{Along, Lineage, OfVertex};
use crate::{Error, cancel};
use delone::predicates::fraction_along;
use delone::{Point, Pslg, VertexId, Watch};

/// Most disagreements that are put into words.
const MOST_NAMED: usize = 16;

/// Disagreements in words, and how many there are.
#[derive(Default)]
struct Words {
    listed: Vec<String>,
    more: usize,
}

impl Words {
    fn push(&mut self, words: impl FnOnce() -> String) {
        match self.listed.len() < MOST_NAMED {
            true => self.listed.push(format!("lineage: {}", words())),
            false => self.more += 1,
        }
    }
}

impl Lineage {
    /// Returns for each segment of the input the vertices along it, as the rows have them; a segment without rows has
    /// its first end alone.
    pub fn chains(&self, input: &Pslg) -> Vec<Vec<VertexId>> {
        let kept = |v: VertexId| match self.vertices.get(v.index()) {
            Some(&OfVertex::Duplicate(kept)) => kept,
            _ => v,
        };
        let mut chains: Vec<_> = input.segments.iter().map(|s| vec![kept(s[0])]).collect();
        for edge in &self.edges {
            if let Some(chain) = chains.get_mut(edge.segment) {
                chain.push(edge.ends[1]);
            }
        }
        chains
    }

    /// Says in words what is wrong with this table for a mesh of these points and constrained edges, whose triangles
    /// have been proven to lie in these regions; nothing if it is right.
    ///
    /// # Errors
    /// If the watch cancels.
    ///
    /// *Cost*: O(n log n), mostly for telling duplicates.
    pub fn disagreements(
        &self,
        input: &Pslg,
        points: &[Point],
        edges: &[[VertexId; 2]],
        regions: Option<&[Option<usize>]>,
        watch: &dyn Watch,
    ) -> Result<Vec<String>, Error> {
        let mut words = Words::default();
        if self.vertices.len() != points.len() || points.len() < input.points.len() {
            let (rows, all) = (self.vertices.len(), points.len());
            words.push(|| format!("{rows} rows for {all} vertices"));
            return Ok(words.listed);
        }
        self.check_input(input, points, &mut words, watch)?;
        let mut on_chains = self.check_chains(input, points, &mut words, watch)?;
        on_chains.sort_unstable();
        self.check_added(input, points, &on_chains, &mut words, watch)?;
        self.check_free(input, points, &mut words, watch)?;
        self.check_edges(edges, &mut words, watch)?;
        if self.regions.as_deref() != regions {
            words.push(|| "triangles are not in the regions that were proven".to_owned());
        }
        if words.more > 0 {
            words
                .listed
                .push(format!("lineage: and {} more", words.more));
        }
        Ok(words.listed)
    }

    /// Requires each point of the input to be itself, or the first of those that it equals.
    fn check_input(
        &self,
        input: &Pslg,
        points: &[Point],
        words: &mut Words,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        let n = input.points.len();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_unstable_by(|&i, &j| points[i].lex_cmp(&points[j]).then(i.cmp(&j)));
        for (round, group) in order.chunk_by(|&i, &j| points[i] == points[j]).enumerate() {
            cancel::check(watch, round)?;
            for &i in group {
                let expected = match i == group[0] {
                    true => OfVertex::Input,
                    false => OfVertex::Duplicate(VertexId::new(group[0])),
                };
                if self.vertices[i] != expected {
                    let row = self.vertices[i];
                    words.push(|| format!("vertex {i} is said to be {row:?}, it is {expected:?}"));
                }
            }
        }
        Ok(())
    }

    /// Requires the rows of each segment to be a way from its first end to its second; returns which added vertices
    /// are on which segments.
    fn check_chains(
        &self,
        input: &Pslg,
        points: &[Point],
        words: &mut Words,
        watch: &dyn Watch,
    ) -> Result<Vec<(VertexId, usize)>, Error> {
        let n = input.points.len();
        let mut on_chains = Vec::new();
        let mut is_there = vec![false; input.segments.len()];
        let mut last = None;
        for (round, rows) in self
            .edges
            .chunk_by(|a, b| a.segment == b.segment)
            .enumerate()
        {
            cancel::check(watch, round)?;
            let segment = rows[0].segment;
            if last >= Some(segment) {
                words.push(|| format!("segment {segment} comes behind {last:?}"));
            }
            last = Some(segment);
            let ends = [rows[0].ends[0], rows[rows.len() - 1].ends[1]];
            let all = rows.iter().flat_map(|row| row.ends);
            if let Some(v) = all.clone().find(|v| v.index() >= points.len()) {
                words.push(|| format!("an edge of segment {segment} ends in vertex {v}"));
                continue;
            }
            let at = |v: VertexId| points[v.index()];
            let drawn = match input.segments.get(segment) {
                Some(drawn) => {
                    is_there[segment] = true;
                    drawn.map(at)
                }
                // An edge of the hull has the points of the input at its ends that its chain has.
                None => ends.map(at),
            };
            let is_hull = segment >= input.segments.len();
            if ends.map(at) != drawn || is_hull && ends.iter().any(|v| v.index() >= n) {
                words
                    .push(|| format!("the edges of segment {segment} do not lead from end to end"));
            }
            if rows
                .windows(2)
                .any(|pair| pair[0].ends[1] != pair[1].ends[0])
            {
                words.push(|| format!("the edges of segment {segment} are no chain"));
            }
            for row in rows {
                let expected = row.ends.map(|v| fraction_along(drawn, at(v)));
                if expected != row.at {
                    let [given, found] = [row.at, expected];
                    words.push(|| {
                        format!("an edge of segment {segment} is at {given:?}, not at {found:?}")
                    });
                }
                let added = Some(row.ends[1]).filter(|v| v.index() >= n);
                on_chains.extend(added.map(|v| (v, segment)));
            }
        }
        for (segment, ends) in input.segments.iter().enumerate() {
            let has_length = input.points[ends[0].index()] != input.points[ends[1].index()];
            if has_length && !is_there[segment] {
                words.push(|| format!("segment {segment} is lost"));
            }
        }
        Ok(on_chains)
    }

    /// Requires added vertices to be on the segments that they are said to be on, at the places that they have.
    fn check_added(
        &self,
        input: &Pslg,
        points: &[Point],
        on_chains: &[(VertexId, usize)],
        words: &mut Words,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        let ends = self.ends(input, points);
        let mut begin = 0;
        for v in input.points.len()..points.len() {
            cancel::check(watch, v)?;
            let id = VertexId::new(v);
            let end = begin + on_chains[begin..].partition_point(|on| on.0 <= id);
            let on = &on_chains[begin..end];
            begin = end;
            let is_at = |place: Along| {
                let drawn = match input.segments.get(place.segment) {
                    Some(drawn) => Some(drawn.map(|v| points[v.index()])),
                    None => ends
                        .binary_search_by_key(&place.segment, |(segment, _)| *segment)
                        .ok()
                        .map(|i| ends[i].1),
                };
                let is_passed = on.iter().any(|&(_, segment)| segment == place.segment);
                is_passed && drawn.is_some_and(|ends| fraction_along(ends, points[v]) == place.at)
            };
            let row = self.vertices[v];
            let is_right = match row {
                OfVertex::Free(_) => on.is_empty(),
                OfVertex::OnSegment(place) => {
                    is_at(place) && on.iter().all(|&(_, segment)| segment >= place.segment)
                }
                OfVertex::Crossing([a, b]) => a.segment < b.segment && is_at(a) && is_at(b),
                OfVertex::Input | OfVertex::Duplicate(_) => false,
            };
            if !is_right {
                let on: Vec<usize> = on.iter().map(|on| on.1).collect();
                words
                    .push(|| format!("vertex {v} is said to be {row:?}, it is on segments {on:?}"));
            }
        }
        Ok(())
    }

    /// Requires free vertices to have the corners and weights of the triangle in which they lie, of the input's
    /// triangulation.
    fn check_free(
        &self,
        input: &Pslg,
        points: &[Point],
        words: &mut Words,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        let n = input.points.len();
        let is_steiner = |of: &OfVertex| !matches!(of, OfVertex::Crossing(_));
        let added = &self.vertices[n..];
        let num_corners = n + added.iter().take_while(|of| !is_steiner(of)).count();
        let behind = &self.vertices[num_corners..];
        if let Some(i) = behind.iter().position(|of| !is_steiner(of)) {
            let v = num_corners + i;
            words.push(|| format!("the crossing at vertex {v} comes behind Steiner points"));
        }
        let behind = (num_corners..).map(VertexId::new).zip(behind);
        let given = behind.filter_map(|(v, of)| match of {
            OfVertex::Free(within) => Some((v, within)),
            _ => None,
        });
        let (free, given): (Vec<_>, Vec<_>) = given.unzip();
        let chains = self.chains(input);
        let chains = chains.iter().map(Vec::as_slice);
        let places = match places(points, num_corners, chains, &free, watch) {
            Ok(places) => places,
            Err(delone::Error::Cancelled) => return Err(Error::Cancelled),
            Err(error) => {
                words.push(|| format!("the chains of segments are not planar: {error}"));
                return Ok(());
            }
        };
        for ((v, given), place) in free.into_iter().zip(given).zip(places) {
            cancel::check(watch, v.index())?;
            let problem = match place {
                Some(place) => place.problem(given, v, points, num_corners),
                None => Some(format!("vertex {v} lies in no triangle of the input")),
            };
            if let Some(problem) = problem {
                words.push(|| problem);
            }
        }
        Ok(())
    }

    /// Lists the ends of hull edges, which few meshes have.
    fn ends(&self, input: &Pslg, points: &[Point]) -> Vec<(usize, [Point; 2])> {
        let first = self
            .edges
            .partition_point(|e| e.segment < input.segments.len());
        let groups = self.edges[first..].chunk_by(|a, b| a.segment == b.segment);
        let ends = groups.filter_map(|rows| {
            let ends = [rows.first()?.ends[0], rows.last()?.ends[1]];
            let [a, b] = ends.map(|v| points.get(v.index()).copied());
            Some((rows[0].segment, [a?, b?]))
        });
        ends.collect()
    }

    /// Requires rows for each constrained edge, and no others.
    fn check_edges(
        &self,
        edges: &[[VertexId; 2]],
        words: &mut Words,
        watch: &dyn Watch,
    ) -> Result<(), Error> {
        let sorted = |ends: &[VertexId; 2]| [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let mut expected: Vec<_> = edges.iter().map(sorted).collect();
        let mut given: Vec<_> = self.edges.iter().map(|row| sorted(&row.ends)).collect();
        for all in [&mut expected, &mut given] {
            all.sort_unstable();
            all.dedup();
        }
        for (i, edge) in expected.iter().enumerate() {
            cancel::check(watch, i)?;
            if given.binary_search(edge).is_err() {
                words.push(|| format!("constrained edge {} – {} has no row", edge[0], edge[1]));
            }
        }
        for (i, edge) in given.iter().enumerate() {
            cancel::check(watch, i)?;
            if expected.binary_search(edge).is_err() {
                words.push(|| format!("edge {} – {} is not constrained", edge[0], edge[1]));
            }
        }
        Ok(())
    }
}
