//! Against the text, which compares each datum with each center.

use super::*;
use crate::predicates::compare_distances;
use crate::scattered::samples;
use delone_testkit::generate::Kind;

/// Everything anew for every split.
struct Naive<'d> {
    data: &'d [Point],
    positions: Vec<Point>,
    owners: Vec<usize>,
}

impl<'d> Naive<'d> {
    fn new(data: &'d [Point]) -> Self {
        let extent = Extent::of(data.iter().copied()).expect("data");
        Self {
            data,
            positions: vec![extent.mean(data.iter().copied())],
            owners: vec![0; data.len()],
        }
    }

    fn of(&self, center: usize) -> Vec<Point> {
        let pairs = self.data.iter().zip(&self.owners);
        pairs
            .filter(|(_, owner)| **owner == center)
            .map(|(&p, _)| p)
            .collect()
    }

    fn split(&mut self) -> Option<Split> {
        let all = (0..self.positions.len()).map(|c| (c, self.of(c)));
        let can = |own: &Vec<Point>| own.iter().any(|p| p != &own[0]);
        let (center, own) = all
            .filter(|(_, own)| can(own))
            .min_by_key(|(c, own)| (Reverse(own.len()), *c))?;
        let least = |f: fn(&Point) -> f64| own.iter().map(f).fold(f64::INFINITY, f64::min);
        let most = |f: fn(&Point) -> f64| own.iter().map(f).fold(f64::NEG_INFINITY, f64::max);
        let extent = Extent {
            low: Point::new(least(|p| p.x), least(|p| p.y)),
            high: Point::new(most(|p| p.x), most(|p| p.y)),
        };
        let cut = middle(extent)?;
        let is_lower = |p: &Point| match cut {
            Cut::Vertical(x) => p.x <= x,
            Cut::Horizontal(y) => p.y <= y,
        };
        let data = own.len();
        let (lower, upper): (Vec<Point>, Vec<Point>) = own.into_iter().partition(is_lower);
        let after = [lower, upper].map(|half| {
            let extent = Extent::of(half.iter().copied()).expect("data on both sides");
            extent.mean(half.iter().copied())
        });
        let before = self.positions[center];
        let centers = [center, self.positions.len()];
        self.positions[center] = after[0];
        self.positions.push(after[1]);
        self.owners = self.data.iter().map(|&p| self.nearest(p)).collect();
        Some(Split {
            centers,
            before,
            after,
            cut,
            data,
        })
    }

    fn nearest(&self, p: Point) -> usize {
        let at = |c: usize| self.positions[c];
        let all = 0..self.positions.len();
        all.min_by(|&c, &d| compare_distances(p, at(c), at(d)))
            .expect("a center")
    }
}

/// Which center has each datum.
fn owners(centers: &Centers) -> Vec<usize> {
    let mut owners = vec![usize::MAX; centers.data.len()];
    for center in 0..centers.positions.len() {
        for &i in centers.data_of(center) {
            assert_eq!(owners[i as usize], usize::MAX, "two have it");
            owners[i as usize] = center;
        }
    }
    owners
}

fn compare(data: &[Point], splits: usize, name: &str) -> usize {
    let mut centers = Centers::new(data);
    let mut naive = Naive::new(data);
    for round in 0..splits {
        let split = centers.split();
        assert_eq!(split, naive.split(), "{name}, split {round}");
        assert_eq!(
            centers.positions(),
            naive.positions,
            "{name}, split {round}"
        );
        assert_eq!(owners(&centers), naive.owners, "{name}, split {round}");
        assert_eq!(centers.counts().iter().sum::<usize>(), data.len());
        if split.is_none() {
            assert_eq!(centers.split(), None);
            return round;
        }
    }
    splits
}

/// Different points of a kind.
fn distinct(kind: Kind, n: usize, seed: u64) -> Vec<Point> {
    let mut points = samples(kind, n, seed);
    let mut seen = std::collections::BTreeSet::new();
    points.retain(|p| seen.insert([(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()]));
    points
}

#[test]
fn all_kinds_of_data_are_shared_as_the_text_says() {
    for kind in Kind::ALL {
        for (n, seed) in [
            (1, 0),
            (2, 1),
            (3, 2),
            (7, 3),
            (40, 4),
            (40, 5),
            (40, 6),
            (160, 7),
        ] {
            compare(&distinct(kind, n, seed), n, &format!("{n} of {kind:?}"));
        }
    }
}

#[test]
fn equal_data_stay_together() {
    for kind in [
        Kind::Duplicates,
        Kind::Lattice { side: 3 },
        Kind::Lattice { side: 5 },
    ] {
        for seed in 0..6 {
            compare(&samples(kind, 80, seed), 80, &format!("{kind:?}"));
        }
    }
    let same = [Point::new(1.0, 2.0); 5];
    assert_eq!(compare(&same, 3, "one place"), 0);
}

#[test]
fn lattices_full_of_ties_are_shared_as_the_text_says() {
    for side in 2..14_usize {
        // In rows, in columns, and in a scattered order.
        for step in [1, side, 5] {
            let n = side * side;
            let at = |i: usize| {
                let i = i * step % n + if step == side { i / side } else { 0 };
                Point::new((i % n / side) as f64, (i % side) as f64)
            };
            let data: Vec<Point> = (0..n).map(at).collect();
            compare(&data, n, &format!("lattice {side} {step}"));
        }
        let row: Vec<Point> = (0..side * 7)
            .map(|i| Point::new(i as f64, 2.0 * i as f64))
            .collect();
        compare(&row, row.len(), "row");
    }
}

#[test]
fn a_few_hundred_centers_are_right() {
    for kind in [
        Kind::Lattice { side: 20 },
        Kind::CocircularRings,
        Kind::Clusters,
        Kind::Uniform,
    ] {
        compare(&distinct(kind, 500, 9), 250, &format!("{kind:?}"));
    }
}

#[test]
fn nothing_has_no_center() {
    let mut none = Centers::new(&[]);
    assert_eq!(none.split(), None);
    assert!(none.positions().is_empty() && none.counts().is_empty());
}

#[test]
fn boxes_are_cut_at_the_longer_side() {
    let cut = |low: [f64; 2], high: [f64; 2]| {
        let [low, high] = [low, high].map(Point::from);
        middle(Extent { low, high })
    };
    assert_eq!(cut([0.0, 0.0], [4.0, 2.0]), Some(Cut::Vertical(2.0)));
    assert_eq!(cut([0.0, 0.0], [2.0, 4.0]), Some(Cut::Horizontal(2.0)));
    assert_eq!(cut([0.0, 1.0], [2.0, 3.0]), Some(Cut::Vertical(1.0)));
    assert_eq!(cut([1.0, 1.0], [1.0, 1.0]), None);
    let next = 1.0_f64.next_up();
    assert_eq!(cut([1.0, 1.0], [next, 1.0]), Some(Cut::Vertical(1.0)));
    assert_eq!(
        cut([next, 1.0], [next.next_up(), 1.0]),
        Some(Cut::Vertical(next))
    );
    assert_eq!(cut([0.0, 0.0], [0.0, 5e-324]), Some(Cut::Horizontal(0.0)));
    let most = f64::MAX;
    assert_eq!(cut([-most, -most], [most, 0.0]), Some(Cut::Vertical(0.0)));
}
