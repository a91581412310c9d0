//! What has become of a drawing, and of each of its parts.

use super::Work;
use crate::doctor::graph::sorted;
use crate::doctor::near::distance;
use crate::predicates::length_up;
use crate::{Point, Pslg, VertexId};

/// A drawing after its repair, and the way there.
///
/// - Points of the input move at most once, by at most the tolerance; without tolerance, none does.
/// - Segments go through vertices within the tolerance of the segment between their snapped ends, so that no
///   place of one is farther than twice the tolerance from where it was, but for the rounding of cuts.
/// - Segments of no length go, those equal to others too, except in polygons, which keep their own. Points,
///   holes and regions all stay, lines that hang loose as well.
/// - The result depends on the points and segments alone, and not on their order.
/// - Segments meet at common ends only. If it [is settled](Self::is_settled), near misses are left only where
///   mending them would have broken these bounds.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Repair {
    /// The repaired drawing: first the points of the input that are left, in their order, then those of cuts,
    /// by x, then y.
    pub pslg: Pslg,
    /// For each point of the result that of the input that it is; `None` if it is a cut.
    pub sources: Vec<Option<VertexId>>,
    /// For each cut two segments of the input that crossed there.
    pub crossings: Vec<[usize; 2]>,
    /// For each point of the input the one of the result that stands for it.
    pub vertex_of: Vec<VertexId>,
    /// For each segment of the input the vertices along it; one, if nothing is left of it.
    pub chains: Vec<Vec<VertexId>>,
    /// For each segment of the result those of the input that go along it, ascending; a segment of a polygon
    /// only names its own.
    pub owners: Vec<Vec<usize>>,
    /// Rounds of bending and noding.
    pub rounds: usize,
    /// Whether nothing was left to do.
    pub is_settled: bool,
    input: Vec<Point>,
    ends: Vec<[VertexId; 2]>,
}

/// A point that has moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// The point of the input.
    pub point: VertexId,
    /// The point of the result that stands for it.
    pub to: VertexId,
    /// Where it was.
    pub from: Point,
    /// Where it is.
    pub at: Point,
    /// How far that is, rounded up.
    pub distance: f64,
}

/// A vertex that a segment goes through now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bent {
    /// The segment of the input.
    pub segment: usize,
    /// The point of the result, which is no cut.
    pub through: VertexId,
    /// Where it is.
    pub at: Point,
    /// How far that is from the segment as it was, rounded; zero if it was on it.
    pub distance: f64,
}

impl Repair {
    /// Lists the points that have moved, ascending.
    pub fn moved(&self) -> impl Iterator<Item = Moved> + '_ {
        let all = self.input.iter().zip(&self.vertex_of).enumerate();
        all.filter_map(|(point, (&from, &to))| {
            let at = self.pslg.points[to.index()];
            (from != at).then(|| Moved {
                point: VertexId::new(point),
                to,
                from,
                at,
                distance: length_up([from, at]),
            })
        })
    }

    /// Lists the points that another one stands for, ascending, with that one; both of the input.
    pub fn merged(&self) -> impl Iterator<Item = [VertexId; 2]> + '_ {
        let all = self.vertex_of.iter().enumerate();
        all.filter_map(|(point, to)| {
            let source = self.sources[to.index()].expect("bug: a point became a cut");
            (source.index() != point).then(|| [VertexId::new(point), source])
        })
    }

    /// Lists the vertices of the input that split segments, by segment, then along it.
    pub fn bent(&self) -> impl Iterator<Item = Bent> + '_ {
        self.chains
            .iter()
            .enumerate()
            .flat_map(move |(segment, chain)| {
                let inner = chain.get(1..chain.len().max(2) - 1).unwrap_or(&[]);
                let ends = self.ends[segment].map(|v| self.input[v.index()]);
                let inner = inner.iter().filter(|v| self.sources[v.index()].is_some());
                inner.map(move |&through| {
                    let at = self.pslg.points[through.index()];
                    Bent {
                        segment,
                        through,
                        at,
                        distance: distance(ends, at),
                    }
                })
            })
    }

    /// Lists the segments of which nothing is left, ascending.
    pub fn vanished(&self) -> impl Iterator<Item = usize> + '_ {
        let all = self.chains.iter().enumerate();
        all.filter(|(_, chain)| chain.len() < 2).map(|(s, _)| s)
    }

    /// Lists the segments all of which lies along earlier ones, ascending: they are not repeated.
    pub fn doubled(&self) -> Vec<usize> {
        let mut is_first = vec![false; self.chains.len()];
        for owners in &self.owners {
            owners.first().into_iter().for_each(|&s| is_first[s] = true);
        }
        let all = 0..self.chains.len();
        all.filter(|&s| self.chains[s].len() > 1 && !is_first[s])
            .collect()
    }

    /// Tells whether the result is the input, point by point and segment by segment.
    pub fn is_unchanged(&self) -> bool {
        self.pslg.points == self.input && self.pslg.segments == self.ends
    }
}

impl Work<'_> {
    /// Numbers what is left, and reads the segments off the chains.
    pub(super) fn finish(self) -> Repair {
        let inputs = self.input.points.len();
        let mut vertices = self.vertices();
        let cuts = vertices.partition_point(|&v| (v as usize) < inputs);
        vertices[cuts..].sort_unstable_by(|&u, &v| {
            let [p, q] = [u, v].map(|v| self.points[v as usize]);
            p.lex_cmp(&q)
        });
        let mut number = vec![VertexId::INFINITE; self.points.len()];
        for (i, &v) in vertices.iter().enumerate() {
            number[v as usize] = VertexId::new(i);
        }
        let named = |chain: &Vec<u32>| chain.iter().map(|&v| number[v as usize]).collect();
        let chains: Vec<Vec<VertexId>> = self.chains.iter().map(named).collect();
        let (segments, owners, polygons) = self.pieces(&number);
        let source = |&v: &u32| ((v as usize) < inputs).then(|| VertexId::from(v));
        let crossing = |&v: &u32| self.crossings[v as usize - inputs].map(|s| s as usize);
        Repair {
            sources: vertices.iter().map(source).collect(),
            crossings: vertices[cuts..].iter().map(crossing).collect(),
            vertex_of: self.home.iter().map(|&v| number[v as usize]).collect(),
            chains,
            owners,
            rounds: self.rounds,
            is_settled: self.is_settled,
            pslg: Pslg {
                points: vertices.iter().map(|&v| self.points[v as usize]).collect(),
                segments,
                polygons,
                holes: self.input.holes.clone(),
                regions: self.input.regions.clone(),
            },
            input: self.input.points.clone(),
            ends: self.input.segments.clone(),
        }
    }

    /// Lists the pieces of all chains in the order of the input, each once, but those of polygons all.
    #[allow(clippy::type_complexity, reason = "taken apart at once")]
    fn pieces(
        &self,
        number: &[VertexId],
    ) -> (
        Vec<[VertexId; 2]>,
        Vec<Vec<usize>>,
        Vec<std::ops::Range<usize>>,
    ) {
        let mut is_of_polygon = vec![false; self.chains.len()];
        for range in &self.input.polygons {
            is_of_polygon[range.clone()].fill(true);
        }
        // The first piece along each edge, and where it is listed.
        let mut edges: Vec<([u32; 2], u32, u32)> = Vec::new();
        for (s, chain) in (0..).zip(&self.chains) {
            for (k, &ends) in (0..).zip(chain.array_windows()) {
                edges.push((sorted(&self.points, ends), s, k));
            }
        }
        edges.sort_unstable();
        let mut owners_of: Vec<(u32, u32, Vec<usize>)> = Vec::new();
        for group in edges.chunk_by(|a, b| a.0 == b.0) {
            let free = group.iter().filter(|(_, s, _)| !is_of_polygon[*s as usize]);
            let mut free: Vec<(u32, u32)> = free.map(|&(_, s, k)| (s, k)).collect();
            let first = free.first().copied();
            free.dedup_by_key(|&mut (s, _)| s);
            let owners = free.into_iter().map(|(s, _)| s as usize).collect();
            owners_of.extend(first.map(|(s, k)| (s, k, owners)));
        }
        owners_of.sort_unstable();
        let mut next = owners_of.into_iter().peekable();
        let (mut segments, mut owners) = (Vec::new(), Vec::new());
        let mut starts = Vec::with_capacity(self.chains.len() + 1);
        for (s, chain) in (0..).zip(&self.chains) {
            starts.push(segments.len());
            for (k, ends) in (0..).zip(chain.array_windows::<2>()) {
                let own = match is_of_polygon[s as usize] {
                    true => Some(vec![s as usize]),
                    false => next
                        .next_if(|&(t, l, _)| (t, l) == (s, k))
                        .map(|(.., own)| own),
                };
                if let Some(own) = own {
                    segments.push(ends.map(|v| number[v as usize]));
                    owners.push(own);
                }
            }
        }
        starts.push(segments.len());
        let ranges = self.input.polygons.iter();
        let ranges = ranges.map(|range| starts[range.start]..starts[range.end]);
        (segments, owners, ranges.collect())
    }
}
