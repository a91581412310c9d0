//! How short a tour could be, by the bound of Held and Karp (*The traveling-salesman problem and minimum
//! spanning trees*, 1970).
//!
//! Give every site a toll p that is paid at both of the two edges there. All closed tours become longer by
//! 2Σp, so the order of tours stays, but not that of spanning trees; and a tour without its longest edge is
//! a spanning tree, whence
//!
//! > n/(n − 1) · (shortest spanning tree with tolls) − 2Σp ≤ shortest tour.
//!
//! (An open tour is a spanning tree itself, and pays but once at either end.) Tolls that make the tree look
//! like a tour come from a fixed number of subgradient steps: where the tree has more than two edges the
//! toll rises, at its leaves it sinks. They are trained on the edges of the triangulation alone, which is
//! fast; but with tolls the shortest tree need not lie there, so that the one tree that counts is found
//! among all pairs (`spanning.rs`). If that takes too long, as it may where distances differ wildly, the
//! tree without tolls counts, which lies in the triangulation.
//!
//! *Exact* in the whole numbers of `sites.rs`.

use super::sites::{Kind, Sites};
use super::spanning::{Candidates, Pairs};
use crate::pace::Pace;
use crate::{Error, Phase, Watch};

/// As far as a distance can be, so that sums do not overflow.
const MOST_TOLL: i64 = 1 << 59;

/// Subgradient steps. Of the gap between tree and bound on evenly spread points they close nine tenths.
const STEPS: usize = 30;

/// The first step, in parts of the distance to the nearest neighbours, and by what it shrinks.
const FIRST_STEP: f64 = 0.4;
const SHRINKAGE: f64 = 0.91;

/// How much of a step the last imbalance has, and the one before it (Helsgaun, *An effective
/// implementation of the Lin–Kernighan traveling salesman heuristic*, 2000).
const MOMENTUM: [f64; 2] = [0.7, 0.3];

/// Returns a sum of distances that no tour falls short of.
pub(super) fn lower_bound(sites: &Sites, watch: &dyn Watch) -> Result<i128, Error> {
    let n = sites.num_places();
    let work = (STEPS as u64 + 2) * n as u64;
    let mut pace = Pace::new(watch, Phase::Tour, work);
    let mut candidates = Candidates::new(sites);
    let mut tolls = vec![0; n];
    let plain = value(sites, candidates.shortest(&tolls, &mut pace)?, &tolls);
    let mut best = (plain, tolls.clone());
    let scales = sites.scales();
    let mut last = candidates.degrees().to_vec();
    let mut step = FIRST_STEP;
    for _ in 0..STEPS {
        for (v, toll) in tolls.iter_mut().enumerate() {
            let imbalance = [candidates.degrees()[v], last[v]].map(|d| f64::from(d) - 2.0);
            let imbalance = MOMENTUM[0] * imbalance[0] + MOMENTUM[1] * imbalance[1];
            let moved = *toll + (step * scales[v] * imbalance) as i64;
            *toll = moved.clamp(-MOST_TOLL, MOST_TOLL);
        }
        step *= SHRINKAGE;
        last.copy_from_slice(candidates.degrees());
        let trained = value(sites, candidates.shortest(&tolls, &mut pace)?, &tolls);
        if trained > best.0 {
            best = (trained, tolls.clone());
        }
    }
    let tolls = best.1;
    let true_tree = candidates.shortest_of_all(Pairs::new(sites, &tolls), &tolls, &mut pace)?;
    pace.finish();
    Ok(true_tree.map_or(plain, |tree| plain.max(value(sites, tree, &tolls))))
}

/// The bound that a shortest spanning tree with tolls gives.
fn value(sites: &Sites, tree: i128, tolls: &[i64]) -> i128 {
    let n = tolls.len() as i128;
    let twice: i128 = tolls.iter().map(|&toll| 2 * i128::from(toll)).sum();
    let least = |tolls: &[i64]| i128::from(tolls.iter().copied().min().unwrap_or(0));
    match sites.kind() {
        Kind::Closed => tree + tree.div_euclid(n - 1) - twice,
        // The ends pay but once.
        Kind::From => tree - twice + i128::from(tolls[0]) + least(&tolls[1..]),
        Kind::Free => tree - twice + 2 * least(tolls),
    }
}
