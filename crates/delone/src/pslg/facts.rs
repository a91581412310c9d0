//! Exact facts about a drawing: what is doubled, what meets where it should not, and which ring lies
//! in which.
//!
//! Segments are compared after equal points and equal segments have been merged. All signs are exact.
//! *Cost*: in practice O(n log n + k) for k pairs that meet, memory O(n) however many do: only the
//! first of each kind are listed, all are counted.

use super::Pslg;
use super::listed::{First, Listed};
use super::meeting::{Ends, Meeting, meet};
use super::rings::{self, Ring};
use super::search::{Query, Sweep, tree_of, tree_of_points};
use super::vertices::Vertices;
use crate::parallel::{Workers, with_workers};
use crate::predicates::{Orientation, construct_crossing, orient2d};
use crate::{Error, Point, VertexId, Watch};

/// Exact facts about a [`Pslg`], made by [`Pslg::facts`].
///
/// Of equal points the one of lowest index stands for all, and so of equal segments, whatever their
/// direction. Lists are ascending.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Facts {
    /// Number of points.
    pub points: usize,
    /// Points that equal an earlier one: the point, and the first one equal to it.
    pub duplicates: Listed<[VertexId; 2]>,
    /// Whether all points lie on one line.
    pub is_collinear: bool,
    /// Distinct points that no segment ends in.
    pub loose_points: Listed<VertexId>,
    /// Distinct points in which one segment ends.
    pub open_ends: Listed<VertexId>,
    /// Number of segments.
    pub segments: usize,
    /// Segments whose ends are equal points.
    pub zero_length: Listed<usize>,
    /// Segments that equal an earlier one: the segment, and the first one equal to it.
    pub repeated: Listed<[usize; 2]>,
    /// Pairs of segments that cross in the interior of both, also where there is a vertex.
    pub crossings: Listed<SegmentCrossing>,
    /// Pairs of segments that share more than a point.
    pub overlaps: Listed<[usize; 2]>,
    /// Vertices in the interior of a segment, once for each such segment.
    pub on_segments: Listed<VertexOnSegment>,
    /// The rings: closed chains of segments in whose vertices nothing else ends, by their first segment.
    pub rings: Vec<Ring>,
    /// Whether the rings do not meet, so that it is known which lies in which.
    pub are_rings_apart: bool,
}

/// Two segments that cross.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentCrossing {
    /// Their indices, ascending.
    pub segments: [usize; 2],
    /// Where they cross, rounded to nearest.
    pub at: Point,
}

/// A vertex in the interior of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexOnSegment {
    /// Index of the segment.
    pub segment: usize,
    /// The vertex.
    pub vertex: VertexId,
    /// Its position.
    pub at: Point,
}

impl Facts {
    /// Tells whether segments meet at shared ends only.
    pub fn is_clean(&self) -> bool {
        self.crossings.count + self.overlaps.count + self.on_segments.count == 0
    }
}

impl Pslg {
    /// Finds exact facts about the points and segments, listing the first `limit` of each kind.
    ///
    /// ```
    /// use delone::{Point, Pslg};
    ///
    /// let mut cross = Pslg::from_points([(0.0, 0.0), (2.0, 2.0), (0.0, 2.0), (2.0, 0.0)]);
    /// cross.add_segment(0, 1);
    /// cross.add_segment(2, 3);
    /// let facts = cross.facts(10, &())?;
    /// assert_eq!(facts.crossings.first[0].at, Point::new(1.0, 1.0));
    /// assert_eq!(facts.open_ends.count, 4);
    /// # Ok::<(), delone::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::BadSegment`] name the culprit; [`Error::TooManyPoints`] and
    /// [`Error::TooManySegments`] if 32 bits cannot number them; [`Error::Cancelled`] if the watch says
    /// so.
    pub fn facts(&self, limit: usize, watch: &dyn Watch) -> Result<Facts, Error> {
        check(self)?;
        let found = with_workers(None, |workers| survey(self, limit, workers, watch))?;
        found.ok_or(Error::Cancelled)
    }
}

fn check(pslg: &Pslg) -> Result<(), Error> {
    let limit = u32::MAX as usize - 1;
    let given = pslg.points.len();
    if given > limit {
        return Err(Error::TooManyPoints { given, limit });
    }
    let given = pslg.segments.len();
    if given > limit {
        return Err(Error::TooManySegments { given, limit });
    }
    if let Some(index) = pslg.points.iter().position(|p| !p.is_finite()) {
        let Point { x, y } = pslg.points[index];
        return Err(Error::NotFinite { index, x, y });
    }
    let points = pslg.points.len();
    for (segment, ends) in pslg.segments.iter().enumerate() {
        if let Some(&vertex) = ends.iter().find(|v| v.index() >= points) {
            return Err(Error::BadSegment {
                segment,
                vertex,
                points,
            });
        }
    }
    Ok(())
}

/// Collects the facts of a graph whose indices are right.
fn survey(pslg: &Pslg, limit: usize, workers: Workers, watch: &dyn Watch) -> Option<Facts> {
    let vertices = Vertices::new(&pslg.points);
    let mut facts = Facts {
        points: pslg.points.len(),
        segments: pslg.segments.len(),
        ..Facts::default()
    };
    let kept = merge_points(&pslg.points, limit, &mut facts);
    let merged = merge_segments(pslg, &kept, &vertices, limit, &mut facts);
    if watch.is_cancelled() {
        return None;
    }
    facts.is_collinear = is_collinear(&pslg.points);
    let degrees = degrees(&merged.ends, pslg.points.len());
    let with_degree = |degree: u32| {
        let distinct = (0..).zip(&kept).filter(|&(v, &kept)| v == kept);
        let all = distinct.map(|(v, _)| v);
        all.filter(|&v| degrees[v as usize] == degree)
            .collect::<Vec<u32>>()
    };
    let loose = with_degree(0);
    let listed = |list: &[u32]| First::of(limit, list.iter().copied()).listed(VertexId::from);
    facts.loose_points = listed(&loose);
    facts.open_ends = listed(&with_degree(1));
    let all = Meetings {
        limit,
        workers,
        watch,
    };
    all.find(&vertices, &merged, &loose, &mut facts)?;
    let rings = rings::walk(&merged.ends, &degrees);
    facts.are_rings_apart = facts.is_clean() || {
        let mut on_rings: Vec<u32> = rings.iter().flat_map(|r| &r.segments).copied().collect();
        on_rings.sort_unstable();
        let on_rings = merged.only(&on_rings);
        let mut alone = Facts::default();
        all.find(&vertices, &on_rings, &[], &mut alone)?;
        alone.is_clean()
    };
    let nest = facts.are_rings_apart;
    facts.rings = rings::describe(rings, &merged, &vertices, nest, workers, watch)?;
    Some(facts)
}

/// Finds for each point the first equal one.
fn merge_points(points: &[Point], limit: usize, facts: &mut Facts) -> Vec<u32> {
    let at = |v: u32| points[v as usize];
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_unstable_by(|&u, &v| at(u).lex_cmp(&at(v)).then(u.cmp(&v)));
    let mut kept = vec![0; points.len()];
    for group in order.chunk_by(|&u, &v| at(u) == at(v)) {
        for &v in group {
            kept[v as usize] = group[0];
        }
    }
    let dropped = (0..).zip(&kept).filter(|&(v, &kept)| v != kept);
    let pairs = First::of(limit, dropped.map(|(v, &kept)| [v, kept]));
    facts.duplicates = pairs.listed(|pair| pair.map(VertexId::from));
    kept
}

/// The distinct segments that have a length.
#[derive(Default)]
pub(super) struct Merged {
    /// Their ends, the lexicographically smaller first.
    pub ends: Vec<Ends>,
    /// The index of each in the input, ascending.
    pub names: Vec<u32>,
}

impl Merged {
    /// Picks some of the segments, given in ascending order.
    fn only(&self, segments: &[u32]) -> Self {
        let pick = segments.iter().map(|&s| s as usize);
        let (ends, names) = pick.map(|s| (self.ends[s], self.names[s])).unzip();
        Self { ends, names }
    }
}

fn merge_segments(
    pslg: &Pslg,
    kept: &[u32],
    vertices: &Vertices,
    limit: usize,
    facts: &mut Facts,
) -> Merged {
    let ends_of = |s: u32| pslg.segments[s as usize].map(|v| kept[v.index()]);
    let all = 0..pslg.segments.len() as u32;
    let is_zero = |s: &u32| {
        let [a, b] = ends_of(*s);
        a == b
    };
    facts.zero_length = First::of(limit, all.clone().filter(is_zero)).listed(|s| s as usize);
    let with_ends = all
        .filter(|s| !is_zero(s))
        .map(|s| (vertices.sorted(ends_of(s)), s));
    let mut sorted: Vec<(Ends, u32)> = with_ends.collect();
    sorted.sort_unstable();
    let mut repeated = First::new(limit);
    for group in sorted.chunk_by(|a, b| a.0 == b.0) {
        for later in &group[1..] {
            repeated.add([later.1, group[0].1]);
        }
    }
    facts.repeated = repeated.listed(|pair| pair.map(|s| s as usize));
    sorted.dedup_by_key(|(ends, _)| *ends);
    sorted.sort_unstable_by_key(|&(_, s)| s);
    let (ends, names) = sorted.into_iter().unzip();
    Merged { ends, names }
}

fn is_collinear(points: &[Point]) -> bool {
    let least = points.iter().min_by(|p, q| p.lex_cmp(q));
    let largest = points.iter().max_by(|p, q| p.lex_cmp(q));
    let (Some(&a), Some(&b)) = (least, largest) else {
        return true;
    };
    let is_on = |&p: &Point| orient2d(a, b, p) == Orientation::Collinear;
    points.iter().all(is_on)
}

/// Counts the segments that end in each vertex.
fn degrees(ends: &[Ends], vertices: usize) -> Vec<u32> {
    let mut degrees = vec![0; vertices];
    for &v in ends.iter().flatten() {
        degrees[v as usize] += 1;
    }
    degrees
}

/// The search for all meetings of distinct segments and vertices.
struct Meetings<'a> {
    limit: usize,
    workers: Workers,
    watch: &'a dyn Watch,
}

/// What one job has found.
struct Found {
    crossings: First<[u32; 2]>,
    overlaps: First<[u32; 2]>,
    /// Segment and vertex.
    on_segments: First<[u32; 2]>,
}

impl Meetings<'_> {
    fn find(
        &self,
        vertices: &Vertices,
        merged: &Merged,
        loose: &[u32],
        facts: &mut Facts,
    ) -> Option<()> {
        let Merged { ends, names } = merged;
        let all: Vec<u32> = (0..ends.len() as u32).collect();
        let tree = tree_of(vertices, &all, ends, self.workers);
        let loose = tree_of_points(vertices, loose, self.workers);
        let first_at = first_segments(ends, vertices.len());
        let sweep = Sweep {
            workers: self.workers,
            watch: self.watch,
            done: 0,
        };
        let found = sweep.leaves(&tree, |leaf, query, found: &mut Option<Found>| {
            let found = found.get_or_insert_with(|| Found::new(self.limit));
            let Query { stack, ticks } = query;
            let is_going_on = tree.pairs(leaf, stack, |s, t| {
                found.look([s, t], vertices, merged, &first_at);
                ticks.step()
            });
            is_going_on
                && tree.pairs_with(leaf, &loose, stack, |s, v| {
                    let [a, b] = ends[s as usize].map(|v| vertices.at(v));
                    if vertices.is_inside(ends[s as usize], v)
                        && orient2d(a, b, vertices.at(v)) == Orientation::Collinear
                    {
                        found.on_segments.add([names[s as usize], v]);
                    }
                    ticks.step()
                })
        })?;
        let mut sum = Found::new(self.limit);
        for found in found.into_iter().flatten() {
            sum.crossings.join(found.crossings);
            sum.overlaps.join(found.overlaps);
            sum.on_segments.join(found.on_segments);
        }
        sum.describe(vertices, merged, facts);
        Some(())
    }
}

/// Finds for each vertex the first segment that ends in it: the one that reports what it lies on.
fn first_segments(ends: &[Ends], vertices: usize) -> Vec<u32> {
    let mut first = vec![u32::MAX; vertices];
    for (s, ends) in (0..).zip(ends) {
        for &v in ends {
            first[v as usize] = s.min(first[v as usize]);
        }
    }
    first
}

impl Found {
    fn new(limit: usize) -> Self {
        Self {
            crossings: First::new(limit),
            overlaps: First::new(limit),
            on_segments: First::new(limit),
        }
    }

    fn look(&mut self, [s, t]: [u32; 2], vertices: &Vertices, merged: &Merged, first_at: &[u32]) {
        let [ends_s, ends_t] = [s, t].map(|s| merged.ends[s as usize]);
        let [name_s, name_t] = [s, t].map(|s| merged.names[s as usize]);
        let pair = [name_s.min(name_t), name_s.max(name_t)];
        meet(vertices, ends_s, ends_t, |meeting| match meeting {
            Meeting::Crossing => self.crossings.add(pair),
            Meeting::Overlap => self.overlaps.add(pair),
            Meeting::EndOfSecond(v) if first_at[v as usize] == t => {
                self.on_segments.add([name_s, v]);
            }
            Meeting::EndOfFirst(v) if first_at[v as usize] == s => {
                self.on_segments.add([name_t, v]);
            }
            Meeting::EndOfSecond(_) | Meeting::EndOfFirst(_) => {}
        });
    }

    fn describe(self, vertices: &Vertices, merged: &Merged, facts: &mut Facts) {
        let positions = |name: u32| {
            let s = merged
                .names
                .binary_search(&name)
                .expect("bug: a merged segment");
            merged.ends[s].map(|v| vertices.at(v))
        };
        facts.crossings = self.crossings.listed(|pair| {
            let [s, t] = pair.map(positions);
            SegmentCrossing {
                segments: pair.map(|s| s as usize),
                at: construct_crossing(s, t),
            }
        });
        facts.overlaps = self.overlaps.listed(|pair| pair.map(|s| s as usize));
        facts.on_segments = self.on_segments.listed(|[segment, v]| VertexOnSegment {
            segment: segment as usize,
            vertex: v.into(),
            at: vertices.at(v),
        });
    }
}
