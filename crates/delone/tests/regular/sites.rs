//! Kinds of weights for all kinds of points, the degenerate ones first.

use crate::Site;
use delone::Point;
use delone_testkit::generate::{Kind, Random};

/// How weights are chosen for points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Weights {
    Equal,
    /// One of a few integers times the square of the size of the points.
    Few(usize),
    /// Such that many lifted points lie on one plane, as well as `f64` can, some moved off it.
    Plane,
    /// As `Plane`, of two planes that meet in a line.
    Ridge,
    /// Evenly up to the square of the size of the points.
    Even,
    /// Any finite number.
    Any,
}

impl Weights {
    pub const ALL: [Self; 7] = [
        Self::Equal,
        Self::Few(2),
        Self::Few(5),
        Self::Plane,
        Self::Ridge,
        Self::Even,
        Self::Any,
    ];

    fn draw(self, p: Point, size: f64, r: &mut Random) -> f64 {
        let unit = (size * size).clamp(0.0, f64::MAX / 64.0);
        let lift = (p.x * p.x + p.y * p.y).min(f64::MAX);
        let weight = match self {
            Self::Equal => 3.0,
            Self::Few(n) => r.below(n) as f64 * unit,
            Self::Plane if r.below(8) > 0 => lift,
            Self::Plane => lift + (r.below(3) as f64 - 1.0) * unit,
            Self::Ridge => lift - 2.0 * size * p.x.abs().min(f64::MAX / 4.0),
            Self::Even => unit * r.unit(),
            Self::Any => r.finite(),
        };
        weight.clamp(-f64::MAX, f64::MAX)
    }
}

/// Makes `n` sites.
pub fn sites(kind: Kind, weights: Weights, n: usize, seed: u64) -> Vec<Site> {
    let points = kind.points(n, seed);
    let mut r = Random::new(seed + 1000);
    let sizes = points.iter().flat_map(|p| [p.x.abs(), p.y.abs()]);
    // Of a lattice the spacing rather than the extent.
    let size = match kind {
        Kind::Lattice { .. } | Kind::Cross | Kind::Collinear | Kind::CocircularRings => 1.0,
        _ => sizes.fold(0.0, f64::max) / 4.0,
    };
    let sites = points.into_iter();
    sites.map(|p| (p, weights.draw(p, size, &mut r))).collect()
}

/// Calls `check` with sites of every kind and all weights.
pub fn everywhere(numbers: std::ops::Range<usize>, seeds: u64, check: impl Fn(&[Site], &str)) {
    for kind in Kind::ALL {
        for weights in Weights::ALL {
            for seed in 0..seeds {
                let n = Random::new(seed).below(numbers.len()) + numbers.start;
                let name = format!("{kind:?} {weights:?} n {n} seed {seed}");
                check(&sites(kind, weights, n, seed), &name);
            }
        }
    }
}

/// The same sites in another order, and the numbers that they had.
pub fn shuffled(sites: &[Site], seed: u64) -> (Vec<Site>, Vec<usize>) {
    let order = Random::new(seed).permutation(sites.len());
    (order.iter().map(|&i| sites[i]).collect(), order)
}
