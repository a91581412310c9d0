//! Repair: rounds of snapping, bending and noding, until nothing changes.
//!
//! 1. *Snap*, once: vertices are taken by x, then y; each that has no center within the tolerance becomes one,
//!    and every other one moves to its nearest center. So the order of the input plays no part, centers are
//!    more than the tolerance apart, and nothing moves farther than that, however long a chain of near points is.
//! 2. *Bend*: a vertex beside a segment, as [`Kind::NearSegment`](super::Kind::NearSegment) has it, splits it.
//!    Only vertices within the tolerance of the whole segment, from snapped end to snapped end, are let in: its
//!    pieces may not wander off.
//! 3. *Node*: segments that still cross are cut, as triangulation does it. Cuts within the tolerance of
//!    each other or of a vertex become one, again within the tolerance of all segments through them.
//!
//! Bending makes shorter edges of long ones, so that it ends; if it has not after some rounds, what is left is
//! noded and called unsettled. After the last noding, segments meet at common ends only, whatever else is left.
//!
//! After the idea of snap rounding with a bound on the drift (Packer, *Iterated snap rounding with bounded
//! drift*, 2008), on vertices instead of a grid.

mod bend;
mod cuts;
mod outcome;
mod snap;

pub use outcome::{Bent, Moved, Repair};

use super::Doctor;
use super::graph::{merged, sorted};
use crate::parallel::{Workers, with_workers};
use crate::{Error, Point, Pslg, Watch};

/// Rounds of bending and noding, and steps of bending in one.
const MOST_ROUNDS: usize = 12;

/// Repairs a drawing.
pub(super) fn repair(doctor: &Doctor, pslg: &Pslg) -> Result<Repair, Error> {
    // Refuses what is no drawing at all.
    pslg.facts(0, doctor.watch)?;
    crate::pslg::input::check(pslg)?;
    let done = with_workers(None, |workers| {
        let mut work = Work::new(doctor, pslg, workers);
        work.run().map(|()| work.finish())
    })?;
    done.ok_or(Error::Cancelled)
}

/// A drawing under repair.
struct Work<'a> {
    input: &'a Pslg,
    tolerance: f64,
    workers: Workers,
    watch: &'a dyn Watch,
    /// The points of the input, and behind them those of cuts.
    points: Vec<Point>,
    /// For each point of the input the one that stands for it.
    home: Vec<u32>,
    /// For each segment of the input the vertices along it.
    chains: Vec<Vec<u32>>,
    /// For each segment its snapped ends.
    whole: Vec<[Point; 2]>,
    /// For each cut the segments of the input that crossed there.
    crossings: Vec<[u32; 2]>,
    rounds: usize,
    is_settled: bool,
}

impl<'a> Work<'a> {
    fn new(doctor: &Doctor<'a>, input: &'a Pslg, workers: Workers) -> Self {
        Self {
            input,
            tolerance: doctor.tolerance,
            workers,
            watch: doctor.watch,
            points: input.points.clone(),
            home: merged(&input.points),
            chains: Vec::new(),
            whole: Vec::new(),
            crossings: Vec::new(),
            rounds: 0,
            is_settled: false,
        }
    }

    /// Does everything; `None` if the watch cancelled.
    fn run(&mut self) -> Option<()> {
        if self.tolerance > 0.0 {
            self.snap()?;
        }
        let ends = self.input.segments.iter();
        let ends = ends.map(|ends| ends.map(|v| self.home[v.index()]));
        self.chains = ends.map(|[a, b]| compact(vec![a, b])).collect();
        let end = |v: Option<&u32>| self.points[*v.expect("bug: an empty chain") as usize];
        let whole = |chain: &Vec<u32>| [end(chain.first()), end(chain.last())];
        self.whole = self.chains.iter().map(whole).collect();
        while !self.is_settled && self.rounds < MOST_ROUNDS {
            self.rounds += 1;
            let is_bent = self.tolerance > 0.0 && self.bend()?;
            let cuts = self.node()?;
            let is_merged = self.tolerance > 0.0 && self.merge_cuts(cuts)?;
            self.is_settled = !is_bent && !is_merged;
        }
        if !self.is_settled {
            self.node()?;
        }
        Some(())
    }

    /// Lists the edges of all chains with the segments they are of, sorted.
    fn edges(&self) -> Vec<([u32; 2], u32)> {
        let mut edges = Vec::with_capacity(self.chains.len());
        for (s, chain) in (0..).zip(&self.chains) {
            let pairs = chain.array_windows();
            edges.extend(pairs.map(|&ends| (sorted(&self.points, ends), s)));
        }
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// Lists the vertices that there are: those that stand for points, and cuts in chains.
    fn vertices(&self) -> Vec<u32> {
        let homes = (0..).zip(&self.home).filter(|&(v, &home)| v == home);
        let inputs = self.input.points.len() as u32;
        let cuts = self.chains.iter().flatten().filter(|&&v| v >= inputs);
        let mut cuts: Vec<u32> = cuts.copied().collect();
        cuts.sort_unstable();
        cuts.dedup();
        homes.map(|(v, _)| v).chain(cuts).collect()
    }

    /// Puts vertices into edges; `inner` returns those between two ends, the lexicographically smaller first.
    fn lengthen<'i>(&mut self, inner: impl Fn([u32; 2]) -> Option<&'i [u32]>) {
        for chain in &mut self.chains {
            let old = std::mem::take(chain);
            chain.push(old[0]);
            for &[a, b] in old.array_windows() {
                let ends = sorted(&self.points, [a, b]);
                match inner(ends) {
                    Some(inner) if ends[0] == a => chain.extend(inner),
                    Some(inner) => chain.extend(inner.iter().rev()),
                    None => {}
                }
                chain.push(b);
            }
        }
    }
}

/// Removes repetitions of a vertex.
fn compact(mut chain: Vec<u32>) -> Vec<u32> {
    chain.dedup();
    chain
}

/// Sorts pairs by their first parts, and returns the second parts of equal ones together.
fn grouped<K: Ord + Copy>(pairs: &mut Vec<(K, u32)>) -> Vec<(K, Vec<u32>)> {
    pairs.sort_unstable();
    pairs.dedup();
    let groups = pairs.chunk_by(|a, b| a.0 == b.0);
    groups
        .map(|group| (group[0].0, group.iter().map(|&(_, v)| v).collect()))
        .collect()
}
