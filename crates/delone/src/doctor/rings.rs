//! The rings of polygons: open ones, those that touch themselves, and those that lie in the wrong place.
//!
//! A ring is a run of segments of a polygon, each beginning where the one before ends, until the first point
//! comes again. Nesting is judged in polygons whose rings do not meet; where they cross, that is told anyway.
//!
//! *Cost*: O(n log n) for all polygons together.

use super::graph::Graph;
use super::trouble::{Kind, Trouble};
use crate::pslg::Ring;
use crate::{Error, Pslg, VertexId, Watch};
use std::collections::BTreeMap;
use std::ops::Range;

/// Finds what is wrong with the polygons, by kind.
pub(super) fn examine(
    pslg: &Pslg,
    graph: &Graph,
    watch: &dyn Watch,
) -> Result<BTreeMap<Kind, Vec<Trouble>>, Error> {
    let mut found = BTreeMap::new();
    for polygon in 0..pslg.polygons.len() {
        if watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        let one = Polygon {
            pslg,
            graph,
            polygon,
        };
        let rings = one.rings();
        let mut add = |kind, troubles| found.entry(kind).or_insert_with(Vec::new).extend(troubles);
        let open = one.open_points();
        let is_closed = open.is_empty();
        add(Kind::OpenPolygon, open);
        let touches = rings.iter().flat_map(|ring| one.touches(ring));
        add(Kind::SelfTouch, touches.collect());
        if is_closed && rings.len() > 1 {
            add(Kind::Misnested, one.misnested(&rings, watch)?);
        }
    }
    Ok(found)
}

/// One polygon of a drawing.
struct Polygon<'a> {
    pslg: &'a Pslg,
    graph: &'a Graph<'a>,
    polygon: usize,
}

impl Polygon<'_> {
    fn range(&self) -> Range<usize> {
        self.pslg.polygons[self.polygon].clone()
    }

    /// The ends of a segment, of equal points the first.
    fn ends(&self, segment: usize) -> [u32; 2] {
        self.pslg.segments[segment].map(|v| self.graph.kept[v.index()])
    }

    fn trouble(&self, v: u32) -> Trouble {
        Trouble {
            points: vec![VertexId::from(v)],
            polygon: Some(self.polygon),
            at: Some(self.graph.at(v)),
            ..Trouble::default()
        }
    }

    /// Lists the points in which an odd number of segments end.
    fn open_points(&self) -> Vec<Trouble> {
        let mut ends: Vec<u32> = self.range().flat_map(|s| self.ends(s)).collect();
        ends.sort_unstable();
        let groups = ends.chunk_by(|v, w| v == w);
        let odd = groups.filter(|group| group.len() % 2 == 1);
        odd.map(|group| self.trouble(group[0])).collect()
    }

    /// Cuts the segments into rings.
    fn rings(&self) -> Vec<Range<usize>> {
        let Range { start, end } = self.range();
        let (mut rings, mut first) = (Vec::new(), start);
        for s in start..end {
            let [from, to] = [self.ends(first)[0], self.ends(s)[1]];
            let goes_on = s + 1 < end && from != to && to == self.ends(s + 1)[0];
            if !goes_on {
                rings.push(first..s + 1);
                first = s + 1;
            }
        }
        rings
    }

    /// Lists the points that a ring meets twice.
    fn touches(&self, ring: &Range<usize>) -> Vec<Trouble> {
        let with_length = ring.clone().map(|s| self.ends(s)).filter(|[a, b]| a != b);
        let mut starts: Vec<u32> = with_length.map(|[a, _]| a).collect();
        starts.sort_unstable();
        let groups = starts
            .chunk_by(|v, w| v == w)
            .filter(|group| group.len() > 1);
        let trouble = |group: &[u32]| Trouble {
            segments: vec![ring.start],
            ..self.trouble(group[0])
        };
        groups.map(trouble).collect()
    }

    /// Lists the rings that do not lie directly in the first.
    fn misnested(&self, rings: &[Range<usize>], watch: &dyn Watch) -> Result<Vec<Trouble>, Error> {
        let range = self.range();
        let alone = self.alone();
        let facts = alone.facts(0, watch)?;
        let whole: usize = facts.rings.iter().map(|ring| ring.len).sum();
        if !facts.are_rings_apart || whole != range.len() || facts.rings.len() != rings.len() {
            return Ok(Vec::new());
        }
        let is_wrong = |ring: &&Ring| match ring.segment {
            0 => ring.depth != 0,
            _ => ring.depth != 1 || ring.parent.map(|p| facts.rings[p].segment) != Some(0),
        };
        let trouble = |ring: &Ring| {
            let segment = range.start + ring.segment;
            Trouble {
                segments: vec![segment],
                ..self.trouble(self.ends(segment)[0])
            }
        };
        Ok(facts.rings.iter().filter(is_wrong).map(trouble).collect())
    }

    /// The polygon without the rest of the drawing.
    fn alone(&self) -> Pslg {
        let ends: Vec<u32> = self.range().flat_map(|s| self.ends(s)).collect();
        let mut used = ends.clone();
        used.sort_unstable();
        used.dedup();
        let number = |v: &u32| VertexId::new(used.binary_search(v).expect("bug: it is used"));
        let ends: Vec<VertexId> = ends.iter().map(number).collect();
        Pslg {
            segments: ends.as_chunks().0.to_vec(),
            ..Pslg::from_points(used.iter().map(|&v| self.graph.at(v)))
        }
    }
}
