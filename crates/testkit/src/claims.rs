//! What the chapter claims of its examples 3.51 to 3.53 and of Algorithm B, measured on many sets of random data.
//!
//! Every number is that of a cover which [`judge`] has proven right.

use crate::fuzz::cover::{Covering, judge};
use crate::generate::Kind;
use delone::check::CoverCertificate;
use delone::{Event, Observer, Step};

/// Two ways to cover the same sets of data, compared.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Comparison {
    /// Sets of data.
    pub sets: usize,
    /// Smallest angle of a cover in degrees, its mean over all sets, each way.
    pub min_angle: [f64; 2],
    /// The share of sets for which the first way has the larger smallest angle, and that for the second.
    pub better: [f64; 2],
    /// Mean number of triangles, each way.
    pub triangles: [f64; 2],
    /// How often the outer polygon was reduced, its mean over all sets, each way.
    pub reductions: [f64; 2],
}

/// Compares two ways to cover `sets` sets of `n` even random data, at least `least` in each triangle.
///
/// # Panics
/// If a cover is wrong.
pub fn compare(sets: usize, n: usize, least: usize, ways: [&Covering; 2]) -> Comparison {
    let mut sum = Comparison {
        sets,
        ..Comparison::default()
    };
    let share = 1.0 / sets as f64;
    for seed in 0..sets as u64 {
        let runs = ways.map(|way| Run::of(&with_data(way, n, least, seed)));
        for (k, run) in runs.iter().enumerate() {
            let other = &runs[1 - k].certificate;
            sum.min_angle[k] += share * run.certificate.min_angle;
            sum.triangles[k] += share * run.certificate.triangles as f64;
            sum.reductions[k] += share * run.reductions as f64;
            if run.certificate.min_angle > other.min_angle {
                sum.better[k] += share;
            }
        }
    }
    sum
}

/// Returns for which share of the sets Algorithm B leaves Algorithm C nothing to do: no triangle holds 3d data
/// or more.
///
/// # Panics
/// If a cover is wrong.
pub fn share_that_b_finishes(sets: usize, n: usize, least: usize) -> f64 {
    let without_c = Covering {
        divides_triangles: false,
        ..Covering::default()
    };
    let is_finished = |&seed: &u64| {
        let run = Run::of(&with_data(&without_c, n, least, seed));
        run.certificate.most < 3 * least
    };
    (0..sets as u64).filter(is_finished).count() as f64 / sets as f64
}

fn with_data(way: &Covering, n: usize, least: usize, seed: u64) -> Covering {
    Covering {
        data: Kind::Uniform.points(n, seed),
        least,
        ..way.clone()
    }
}

/// A cover that was made, and has been judged.
struct Run {
    certificate: CoverCertificate,
    reductions: usize,
}

impl Run {
    fn of(covering: &Covering) -> Self {
        let mut reductions = Reductions(0);
        let data = covering.data.iter().copied();
        let cover = covering.options().observe(data, &mut reductions);
        let cover = cover.expect("random data can be covered");
        Self {
            certificate: judge(covering, &cover).expect("a cover that is right"),
            reductions: reductions.0,
        }
    }
}

/// Counts how often the outer polygon loses a corner.
struct Reductions(usize);

impl Observer for Reductions {
    fn observe(&mut self, step: Step) {
        self.0 += usize::from(matches!(step.event, Event::OuterReduced { .. }));
    }
}
