//! The rounds of canonical noding: find all that must be cut, then cut it all at once.
//!
//! Subsegments are never changed: one that is cut stays as the parent of its pieces, so that the
//! chains of the input segments can be read off in the end, and pieces that are equal are one
//! subsegment. From the second round on only pairs with a new member are looked at: each round's new
//! subsegments get a tree of their own, which is joined with itself and with all older trees. (New
//! vertices need none: each is an end of a new subsegment.)
//!
//! *Cascades.* Where three or more segments run within a unit in the last place of each other, cutting
//! two moves them across the third, at an angle so small that the next crossing is far away, and so on
//! along the whole length: each round adds half as many vertices again as the last, until, after some
//! 2⁵⁰, the grid is full. A round that finds too many crossings, or comes too late, therefore cuts
//! subsegments at the places of earlier crossings that they pass up to rounding, and places crossings
//! only if nothing is passed any more: snap rounding (Hobby 1999; Guibas and Marimont 1998), which leaves
//! no crossing at all on a uniform grid, and on the grid of `f64` in all tests after a few more rounds.
//! Which rounds these are depends on the set alone, too.

use super::boxes::BoxTree;
use super::meeting::{Ends, Meeting, meet};
use super::noding::Noding;
use super::pieces::Pieces;
use super::search::{Query, Sweep, tree_of, tree_of_points};
use super::sorting::sort;
use super::vertices::{Index, Vertices};
use crate::parallel::Workers;
use crate::predicates::{Orientation, construct_crossing, orient2d, passes};
use crate::{Point, VertexId, Watch};

/// The state between two rounds.
pub(super) struct Rounds<'a> {
    vertices: Vertices<'a>,
    /// The distinct points of the input.
    list: &'a [VertexId],
    pieces: Pieces,
    segments: &'a [[VertexId; 2]],
    /// For each of them its subsegment before the first round.
    roots: Vec<u32>,
    /// The subsegments that are not cut, a tree for each round that made some; the last are new.
    layers: Vec<BoxTree>,
    /// The vertices that no segment of the input ends in.
    loose: BoxTree,
    /// Made when the first crossing has been found.
    index: Option<Index>,
    /// For each added vertex the first pair of segments that cross there.
    crossings: Vec<[u32; 2]>,
    /// Points of the input that crossings were rounded to.
    struck: Vec<u32>,
    /// Rounds that have cut something.
    round: usize,
    /// In how many places the first round found crossings.
    first_places: usize,
    /// Crossings found in a cascade, to be placed when nothing is left to snap.
    waiting: Vec<Crossing>,
    /// Leaves visited so far.
    done: u64,
    workers: Workers,
    watch: &'a dyn Watch,
}

/// Tells whether a round, counted from 0, that finds crossings in so many places is part of a cascade,
/// when the first round found them in `first`. Where segments do not run within rounding of each other,
/// hardly one crossing in a thousand makes another, and two or three rounds are enough.
pub(super) fn is_cascade(round: usize, places: usize, first: usize) -> bool {
    round >= 4 || (round > 0 && places > first / 8 + 8)
}

/// What one job has found.
#[derive(Default)]
struct Found {
    /// Vertices in the interiors of subsegments.
    through: Vec<Cut>,
    crossings: Vec<Crossing>,
}

/// A subsegment, and a vertex at which it must be cut.
type Cut = [u32; 2];

/// Where two subsegments cross.
struct Crossing {
    at: Point,
    pair: [u32; 2],
}

impl<'a> Rounds<'a> {
    /// Merges equal segments and packs them; `None` if the watch cancelled.
    pub fn new(
        points: &'a [Point],
        list: &'a [VertexId],
        segments: &'a [[VertexId; 2]],
        workers: Workers,
        watch: &'a dyn Watch,
    ) -> Option<Self> {
        let go_on = || (!watch.is_cancelled()).then_some(());
        let vertices = Vertices::new(points);
        let mut pieces = Pieces::default();
        let input = segments.iter().zip(0..);
        let input = input.map(|(&ends, i)| (vertices.sorted(ends.map(VertexId::raw)), i));
        let roots = pieces.intern(input, vertices.len(), workers, watch)?;
        let loose = loose_vertices(points.len(), list, segments);
        let loose = tree_of_points(&vertices, &loose, workers);
        go_on()?;
        let all: Vec<u32> = (0..pieces.len() as u32).collect();
        let layers = vec![tree_of(&vertices, &all, &pieces.ends, workers)];
        Some(Self {
            vertices,
            list,
            pieces,
            segments,
            roots,
            layers,
            loose,
            index: None,
            crossings: Vec::new(),
            struck: Vec::new(),
            round: 0,
            first_places: 0,
            waiting: Vec::new(),
            done: 0,
            workers,
            watch,
        })
    }

    /// Makes one round; true if something was cut, `None` if the watch cancelled.
    pub fn step(&mut self) -> Option<bool> {
        let (mut cuts, found) = self.search()?;
        let mut crossings = std::mem::take(&mut self.waiting);
        crossings.retain(|c| !c.pair.iter().any(|&s| self.pieces.is_cut(s)));
        crossings.extend(found);
        let order = |a: &Crossing, b: &Crossing| a.at.lex_cmp(&b.at).then(a.pair.cmp(&b.pair));
        sort(&mut crossings, order, self.workers, self.watch)?;
        let places = crossings.chunk_by(|a, b| a.at == b.at).count();
        if self.round == 0 {
            self.first_places = places;
        }
        let is_cascade = is_cascade(self.round, places, self.first_places);
        if is_cascade {
            self.snap(&mut cuts)?;
        }
        if is_cascade && !cuts.is_empty() {
            self.waiting = crossings;
        } else {
            self.place(&crossings, &mut cuts)?;
        }
        if cuts.is_empty() {
            return Some(false);
        }
        self.cut(cuts)?;
        self.round += 1;
        Some(true)
    }

    /// Adds the places of crossings that subsegments pass, up to rounding, to the cuts. This looks at all
    /// pairs, old ones too: the rounds before did not.
    fn snap(&self, cuts: &mut Vec<Cut>) -> Option<()> {
        let added = self.vertices.num_input() as u32..self.vertices.len() as u32;
        let mut places: Vec<u32> = self.struck.iter().copied().chain(added).collect();
        places.sort_unstable();
        places.dedup();
        let tree = tree_of_points(&self.vertices, &places, self.workers);
        let passed = self
            .sweep()
            .leaves(&tree, |leaf, query, cuts: &mut Vec<Cut>| {
                self.layers.iter().all(|layer| {
                    tree.pairs_with(leaf, layer, &mut query.stack, |v, s| {
                        self.snap_to(s, v, cuts);
                        query.ticks.step()
                    })
                })
            })?;
        cuts.extend(passed.into_iter().flatten());
        Some(())
    }

    fn snap_to(&self, s: u32, v: u32, cuts: &mut Vec<Cut>) {
        let ends = self.positions(self.pieces.ends[s as usize]);
        if !self.pieces.is_cut(s) && passes(ends, self.vertices.at(v)) {
            cuts.push([s, v]);
        }
    }

    /// Finds everything that must be cut, among pairs with a new member.
    fn search(&mut self) -> Option<(Vec<Cut>, Vec<Crossing>)> {
        let (new, old) = self.layers.split_last().expect("bug: no layer");
        let found = self.sweep().leaves(new, |leaf, query, found: &mut Found| {
            self.search_leaf(new, old, leaf, query, found)
        })?;
        self.done += new.num_leaves() as u64;
        let (mut cuts, mut crossings) = (Vec::new(), Vec::new());
        for found in found {
            cuts.extend(found.through);
            crossings.extend(found.crossings);
        }
        Some((cuts, crossings))
    }

    fn sweep(&self) -> Sweep<'a> {
        Sweep {
            workers: self.workers,
            watch: self.watch,
            done: self.done,
        }
    }

    fn search_leaf(
        &self,
        new: &BoxTree,
        old: &[BoxTree],
        leaf: usize,
        query: &mut Query,
        found: &mut Found,
    ) -> bool {
        let Query { stack, ticks } = query;
        let mut is_going_on = new.pairs(leaf, stack, |s, t| {
            self.look([s, t], found);
            ticks.step()
        });
        for layer in old {
            is_going_on = is_going_on
                && new.pairs_with(leaf, layer, stack, |s, t| {
                    if !self.pieces.is_cut(t) {
                        self.look([s, t], found);
                    }
                    ticks.step()
                });
        }
        is_going_on
            && new.pairs_with(leaf, &self.loose, stack, |s, v| {
                if self.is_inside(s, v) {
                    found.through.push([s, v]);
                }
                ticks.step()
            })
    }

    /// Looks at a pair of subsegments.
    fn look(&self, [s, t]: [u32; 2], found: &mut Found) {
        let [ends_s, ends_t] = [s, t].map(|s| self.pieces.ends[s as usize]);
        meet(&self.vertices, ends_s, ends_t, |meeting| match meeting {
            Meeting::EndOfSecond(v) => found.through.push([s, v]),
            Meeting::EndOfFirst(v) => found.through.push([t, v]),
            Meeting::Crossing => {
                let at = construct_crossing(self.positions(ends_s), self.positions(ends_t));
                let pair = [s, t];
                found.crossings.push(Crossing { at, pair });
            }
            // The ends inside say it all.
            Meeting::Overlap => {}
        });
    }

    fn positions(&self, ends: Ends) -> [Point; 2] {
        ends.map(|v| self.vertices.at(v))
    }

    /// Tells whether a vertex lies in the interior of a subsegment.
    fn is_inside(&self, s: u32, v: u32) -> bool {
        let ends = self.pieces.ends[s as usize];
        let [a, b] = self.positions(ends);
        self.vertices.is_inside(ends, v)
            && orient2d(a, b, self.vertices.at(v)) == Orientation::Collinear
    }

    /// Turns crossings, sorted by place, into cuts at vertices, new ones where there are none.
    fn place(&mut self, crossings: &[Crossing], cuts: &mut Vec<Cut>) -> Option<()> {
        if crossings.is_empty() {
            return Some(());
        }
        if self.index.is_none() {
            let list = self.list.iter().map(|v| v.raw());
            self.index = Some(Index::new(&self.vertices, list, self.watch)?);
        }
        for (i, group) in crossings.chunk_by(|a, b| a.at == b.at).enumerate() {
            if i.is_multiple_of(1 << 16) && self.watch.is_cancelled() {
                return None;
            }
            let pairs = group.iter().map(|c| self.pieces.owners_of(c.pair));
            let v = self.vertex_at(group[0].at, pairs.min().expect("bug: an empty group"));
            for s in group.iter().flat_map(|c| c.pair) {
                // At its own end nothing is cut, only the partner.
                if !self.pieces.ends[s as usize].contains(&v) {
                    cuts.push([s, v]);
                }
            }
        }
        Some(())
    }

    /// Finds or adds the vertex where a pair of input segments cross.
    fn vertex_at(&mut self, at: Point, pair: [u32; 2]) -> u32 {
        let index = self.index.as_mut().expect("bug: no index");
        if let Some(v) = index.get(at) {
            match (v as usize).checked_sub(self.vertices.num_input()) {
                Some(added) => self.crossings[added] = self.crossings[added].min(pair),
                None => self.struck.push(v),
            }
            return v;
        }
        let v = VertexId::new(self.vertices.len()).raw();
        index.insert(at, v);
        self.vertices.added.push(at);
        self.crossings.push(pair);
        v
    }

    /// Replaces subsegments by the chains through their cuts, and packs what is new.
    fn cut(&mut self, mut cuts: Vec<Cut>) -> Option<()> {
        sort(&mut cuts, Ord::cmp, self.workers, self.watch)?;
        cuts.dedup();
        let first = self.pieces.len() as u32;
        self.pieces
            .cut(&cuts, &self.vertices, self.workers, self.watch)?;
        if self.watch.is_cancelled() {
            return None;
        }
        let (pieces, workers) = (&self.pieces, self.workers);
        for layer in &mut self.layers {
            let is_whole = |s: &u32| !pieces.is_cut(*s);
            let whole: Vec<u32> = layer.items().iter().copied().filter(is_whole).collect();
            // What is cut need not be found again; a tree that is mostly dead is made anew.
            if 2 * whole.len() < layer.items().len() {
                *layer = tree_of(&self.vertices, &whole, &pieces.ends, workers);
            }
        }
        let new: Vec<u32> = (first..pieces.len() as u32).collect();
        self.layers.retain(|layer| !layer.items().is_empty());
        self.layers
            .push(tree_of(&self.vertices, &new, &pieces.ends, workers));
        Some(())
    }

    /// Numbers the added vertices by x, then y, and reads off the chains; `None` if the watch
    /// cancelled.
    pub fn finish(self) -> Option<Noding> {
        let Self {
            vertices,
            pieces,
            crossings,
            workers,
            watch,
            ..
        } = self;
        let starts = self.segments.iter().map(|ends| ends[0].raw());
        let roots = starts.zip(self.roots);
        let mut order: Vec<usize> = (0..vertices.added.len()).collect();
        let compare = |&a: &usize, &b: &usize| vertices.added[a].lex_cmp(&vertices.added[b]);
        sort(&mut order, compare, workers, watch)?;
        let n = vertices.num_input();
        let mut names = vec![0; order.len()];
        for (name, &v) in order.iter().enumerate() {
            names[v] = n + name;
        }
        let name =
            |v: u32| VertexId::new((v as usize).checked_sub(n).map_or(v as usize, |i| names[i]));
        Some(Noding {
            points: order.iter().map(|&v| vertices.added[v]).collect(),
            crossings: order.iter().map(|&v| crossings[v]).collect(),
            chains: pieces.chains(roots, name, watch)?,
        })
    }
}

/// Lists the vertices that no segment ends in.
fn loose_vertices(points: usize, list: &[VertexId], segments: &[[VertexId; 2]]) -> Vec<u32> {
    let mut is_end = vec![false; points];
    for v in segments.iter().flatten() {
        is_end[v.index()] = true;
    }
    let loose = list.iter().filter(|v| !is_end[v.index()]);
    loose.map(|v| v.raw()).collect()
}
