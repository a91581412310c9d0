//! Which sites take part, and in which order: one for each place, in rounds along the curve.

use crate::delaunay::Curve;
use crate::parallel::Workers;
use crate::{Error, Phase, Point, VertexId, Watch};

/// Sites in different places, in the order of their insertion.
#[derive(Debug, Default)]
pub(super) struct Sites {
    pub points: Vec<Point>,
    pub weights: Vec<f64>,
    /// The caller's numbers.
    pub names: Vec<VertexId>,
}

impl Sites {
    fn with_capacity(n: usize) -> Self {
        Self {
            points: Vec::with_capacity(n),
            weights: Vec::with_capacity(n),
            names: Vec::with_capacity(n),
        }
    }

    pub fn swap(&mut self, i: usize, j: usize) {
        self.points.swap(i, j);
        self.weights.swap(i, j);
        self.names.swap(i, j);
    }
}

/// The first round has about this many sites at most.
const FIRST_ROUND: usize = 64;

/// Chooses the heaviest site of each place, of equally heavy ones that of lowest index, and orders them
/// for insertion; `None` if there are none.
///
/// The Delaunay triangulation of the points orders them along its curve and merges equal ones. It is a
/// tenth of the work, and unlike one sort by cells it tells points apart however close they lie.
pub(super) fn distinct(
    points: &[Point],
    weights: &[f64],
    workers: Workers,
    watch: &dyn Watch,
) -> Result<Option<Sites>, Error> {
    if points.is_empty() {
        return Ok(None);
    }
    let curve = Curve::build(points, workers, &Sorting(watch))?.into_parts();
    let names = heaviest(&curve.points, curve.keys, weights);
    Ok(Some(in_rounds(&names, points, weights)))
}

/// Passes on the progress of sorting only: the rest of the phases is to come.
struct Sorting<'w>(&'w dyn Watch);

impl Watch for Sorting<'_> {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        if phase == Phase::Sort {
            self.0.progress(phase, done, total);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// Lists, for each place along the curve, the site that counts.
fn heaviest(curve: &[Point], keys: Vec<u64>, weights: &[f64]) -> Vec<u32> {
    let is_merged = |&(p, _): &(&Point, &u64)| p.x.is_nan();
    let mut best = Vec::new();
    for (_, &key) in curve.iter().zip(&keys).filter(is_merged) {
        if best.is_empty() {
            best = (0..weights.len() as u32).collect();
        }
        let (dropped, kept) = (key as u32, (key >> 32) as usize);
        if is_stronger(weights, dropped, best[kept]) {
            best[kept] = dropped;
        }
    }
    let places = curve.iter().zip(&keys).filter(|pair| !is_merged(pair));
    let first = places.map(|(_, &key)| key as u32);
    if best.is_empty() {
        first.collect()
    } else {
        first.map(|i| best[i as usize]).collect()
    }
}

fn is_stronger(weights: &[f64], i: u32, j: u32) -> bool {
    let [of_i, of_j] = [i, j].map(|i| weights[i as usize]);
    of_i > of_j || (of_i == of_j && i < j)
}

/// Draws sites into rounds, each about four times the one before, and keeps their order in each.
fn in_rounds(names: &[u32], points: &[Point], weights: &[f64]) -> Sites {
    let first = (names.len() / FIRST_ROUND).max(1).ilog(4) as usize;
    let mut rounds = vec![Vec::new(); first + 1];
    for (place, &name) in (0..).zip(names) {
        let round = mixed(place).trailing_zeros() as usize / 2;
        rounds[round.min(first)].push(name);
    }
    let mut sites = Sites::with_capacity(names.len());
    for name in rounds.into_iter().rev().flatten() {
        let Point { x, y } = points[name as usize];
        // Adding zero turns −0.0 into 0.0.
        sites.points.push(Point::new(x + 0.0, y + 0.0));
        sites.weights.push(weights[name as usize]);
        sites.names.push(VertexId::from(name));
    }
    sites
}

/// The SplitMix64 finaliser (Steele, Lea and Flood 2014): a number that looks random.
fn mixed(i: u64) -> u64 {
    let z = (i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(sites: &[((f64, f64), f64)]) -> Vec<usize> {
        let (points, weights): (Vec<Point>, Vec<f64>) =
            sites.iter().map(|&(p, w)| (Point::from(p), w)).unzip();
        let sites = distinct(&points, &weights, Workers::ONE, &());
        let sites = sites.expect("finite").expect("some");
        let mut names: Vec<_> = sites.names.iter().map(|v| v.index()).collect();
        names.sort_unstable();
        names
    }

    #[test]
    fn of_each_place_the_heaviest_counts_and_of_equal_ones_the_first() {
        let (a, b) = ((0.0, 0.0), (1.0, 2.0));
        assert_eq!(order(&[(a, 1.0), (a, 3.0), (b, 2.0), (a, 2.0)]), [1, 2]);
        assert_eq!(order(&[(b, 0.0), (a, 3.0), (a, 3.0), (b, -0.0)]), [0, 1]);
        assert_eq!(order(&[(a, -1.0), ((-0.0, 0.0), -0.5)]), [1]);
    }

    #[test]
    fn every_site_gets_its_round() {
        let n = 10_000;
        let points: Vec<_> = (0..n).map(|i| Point::new(f64::from(i), 0.0)).collect();
        let names: Vec<u32> = (0..n as u32).collect();
        let sites = in_rounds(&names, &points, &vec![0.0; n as usize]);
        let mut seen: Vec<_> = sites.names.iter().map(|v| v.raw()).collect();
        // The last round has three quarters of all, in order.
        assert!(seen[n as usize * 3 / 10..].is_sorted());
        assert!(!seen[n as usize / 10..].is_sorted());
        seen.sort_unstable();
        assert_eq!(seen, names);
    }
}
