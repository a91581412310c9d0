use super::*;
use crate::{Cut, Event, Log, Phase, Step};
use proptest::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// The algorithm without any thought of speed, by the same formulas.
struct Naive<'a> {
    rows: Vec<&'a [f64]>,
    weights: Vec<f64>,
    owners: Vec<usize>,
    centers: Vec<Vec<f64>>,
}

impl<'a> Naive<'a> {
    fn run(coordinates: &'a [f64], dim: usize, weights: &[f64], n: usize, relax: usize) -> Self {
        let rows: Vec<_> = coordinates.chunks(dim).collect();
        let mut naive = Self {
            weights: weights.to_vec(),
            owners: vec![0; rows.len()],
            centers: vec![vec![]],
            rows,
        };
        naive.center(0);
        while naive.centers.len() < n.min(naive.rows.len()) {
            let errors = (0..naive.centers.len()).map(|c| naive.error(c));
            let errors: Vec<_> = errors.collect();
            let worst = errors.iter().copied().fold(0.0, f64::max);
            if worst == 0.0 {
                break;
            }
            let worst = errors.iter().position(|e| *e == worst).expect("some");
            naive.split(worst);
            for _ in 0..=relax {
                naive.reassign();
            }
        }
        naive
    }

    fn of(&self, c: usize) -> Vec<usize> {
        (0..self.rows.len())
            .filter(|&i| self.owners[i] == c)
            .collect()
    }

    fn heaviest(&self, points: &[usize]) -> f64 {
        points.iter().map(|&i| self.weights[i]).fold(0.0, f64::max)
    }

    fn deviations(&self, c: usize) -> (Vec<f64>, f64) {
        let points = self.of(c);
        let heaviest = self.heaviest(&points);
        let mut sums = vec![0.0; self.rows[0].len()];
        let mut total = 0.0;
        for i in points {
            let share = self.weights[i] / heaviest;
            total += share;
            for (k, sum) in sums.iter_mut().enumerate() {
                let offset = self.rows[i][k] - self.centers[c][k];
                *sum += share * (offset * offset);
            }
        }
        (sums, total)
    }

    fn error(&self, c: usize) -> f64 {
        let (sums, total) = self.deviations(c);
        if total == 0.0 {
            0.0
        } else {
            sums.iter().sum::<f64>() / total
        }
    }

    fn center(&mut self, c: usize) {
        let points = self.of(c);
        let Some(&first) = points.first() else { return };
        let heaviest = self.heaviest(&points);
        let rows = &self.rows;
        let column = |k: usize| points.iter().map(move |&i| (i, rows[i][k]));
        let mean = |k: usize| {
            let first = self.rows[first][k];
            let (mut sum, mut total) = (0.0, 0.0);
            for (i, x) in column(k) {
                sum += self.weights[i] / heaviest * (x - first);
                total += self.weights[i] / heaviest;
            }
            let low = column(k).map(|(_, x)| x).fold(f64::INFINITY, f64::min);
            let high = column(k).map(|(_, x)| x).fold(f64::NEG_INFINITY, f64::max);
            (first + sum / total).clamp(low, high)
        };
        let center = (0..self.rows[0].len()).map(mean).collect();
        self.centers[c] = center;
    }

    fn split(&mut self, c: usize) {
        let (sums, _) = self.deviations(c);
        let largest = sums.iter().copied().fold(0.0, f64::max);
        let axis = sums.iter().position(|s| *s == largest).expect("some");
        let points = self.of(c);
        let mut all: Vec<_> = points.iter().map(|&i| self.rows[i][axis]).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let at = self.centers[c][axis].min(all[all.len() - 1].next_down());
        let new = self.centers.len();
        for i in points {
            if self.rows[i][axis] > at {
                self.owners[i] = new;
            }
        }
        self.centers.push(vec![]);
        self.center(c);
        self.center(new);
    }

    fn reassign(&mut self) {
        for (row, owner) in self.rows.iter().zip(&mut self.owners) {
            let mut best = (f64::INFINITY, 0);
            for (c, center) in self.centers.iter().enumerate() {
                let squares = row.iter().zip(center).map(|(a, b)| (a - b) * (a - b));
                let distance: f64 = squares.fold(0.0, |sum, s| sum + s);
                if distance < best.0 {
                    best = (distance, c);
                }
            }
            *owner = best.1;
        }
        (0..self.centers.len()).for_each(|c| self.center(c));
    }
}

/// Requires that being quick changes nothing.
fn require_as_naive(
    coordinates: &[f64],
    dim: usize,
    weights: Option<&[f64]>,
    n: usize,
    relax: usize,
) {
    let clustering = Clustering::new().clusters(n).relax(relax);
    let found = clustering
        .run(coordinates, dim, weights)
        .expect("good input");
    let ones = vec![1.0; coordinates.len() / dim];
    let naive = Naive::run(coordinates, dim, weights.unwrap_or(&ones), n, relax);
    assert_eq!(found.centers(), naive.centers.concat());
    let owners: Vec<_> = found.assignment().iter().map(|&c| c as usize).collect();
    assert_eq!(owners, naive.owners);
    assert_eq!(found.history().len(), found.len());
    let all: usize = found.clusters().iter().map(|c| c.points).sum();
    assert_eq!(all, naive.rows.len());
    let worst = found.clusters().iter().map(|c| c.error).fold(0.0, f64::max);
    assert_eq!(found.history()[found.len() - 1].worst, worst);
}

/// Numbers from 0 to 1 in an order without pattern.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Sets of points that are awkward in one way or another, with their dimension.
fn awkward() -> Vec<(&'static str, usize, Vec<f64>)> {
    let mut random = noise(1);
    let mut many = |n: usize| (0..n).map(|_| random()).collect::<Vec<_>>();
    let lattice = |side: usize| {
        let all = (0..side * side).flat_map(move |i| [i / side, i % side]);
        all.map(|x| x as f64).collect::<Vec<_>>()
    };
    let circle = (0..90).flat_map(|i| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 90.0).sin_cos();
        [cos, sin]
    });
    let clumps: Vec<_> = many(300)
        .chunks(2)
        .enumerate()
        .flat_map(|(i, p)| [p[0] * 1e-6 + (i % 7) as f64, p[1] * 1e-6 + (i % 3) as f64])
        .collect();
    let uniform = many(400);
    vec![
        ("uniform", 2, uniform.clone()),
        ("in space", 3, many(300)),
        ("on a line", 1, many(120)),
        ("of dimension seven", 7, many(350)),
        ("lattice", 2, lattice(12)),
        ("circle", 2, circle.collect()),
        ("clumps", 2, clumps),
        (
            "duplicates",
            2,
            uniform
                .chunks(2)
                .flat_map(|p| [p[0], p[1], p[0], p[1]])
                .map(|x| (x * 8.0).floor())
                .collect(),
        ),
        ("all equal", 2, vec![3.5; 40]),
        (
            "collinear",
            2,
            (0..80)
                .flat_map(|i| [0.1 * f64::from(i * i), 0.3 * f64::from(i * i)])
                .collect(),
        ),
        (
            "far off",
            2,
            uniform.iter().map(|x| x * 1e-3 + 1e6).collect(),
        ),
        (
            "a few units in the last place apart",
            2,
            uniform
                .iter()
                .map(|x| 1.0 + (x * 5.0).floor() * f64::EPSILON)
                .collect(),
        ),
        ("tiny", 2, uniform.iter().map(|x| x * 1e-80).collect()),
    ]
}

#[test]
fn being_quick_changes_nothing() {
    for (_, dim, coordinates) in awkward() {
        let mut random = noise(7);
        let weights: Vec<_> = (0..coordinates.len() / dim)
            .map(|_| (random() * 12.0 - 6.0).exp2())
            .collect();
        for relax in [0, 3] {
            require_as_naive(&coordinates, dim, None, 60, relax);
            require_as_naive(&coordinates, dim, Some(&weights), 40, relax);
        }
        require_as_naive(&coordinates, dim, None, usize::MAX, 0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn being_quick_changes_nothing_on_small_lattices(
        dim in 1usize..=3,
        raw in prop::collection::vec(0i8..6, 3..90),
        weights in prop::collection::vec(1u8..4, 90),
        n in 1usize..30, relax in 0usize..3,
    ) {
        let whole = raw.len() / dim * dim;
        let coordinates: Vec<_> = raw[..whole].iter().copied().map(f64::from).collect();
        let weights: Vec<_> = weights[..whole / dim].iter().copied().map(f64::from).collect();
        require_as_naive(&coordinates, dim, Some(&weights), n, relax);
    }
}

#[test]
fn every_point_becomes_a_cluster_in_the_end() {
    for (name, dim, coordinates) in awkward() {
        let clusters = Clustering::new()
            .run(&coordinates, dim, None)
            .expect("good input");
        let mut rows: Vec<_> = coordinates.chunks(dim).collect();
        rows.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
        rows.dedup();
        assert_eq!(clusters.len(), rows.len(), "{name}");
        assert!(clusters.clusters().iter().all(|c| c.error == 0.0), "{name}");
    }
}

#[test]
fn powers_of_two_change_nothing_else() {
    let (_, dim, coordinates) = awkward().swap_remove(0);
    let weights: Vec<_> = (0..coordinates.len() / dim)
        .map(|i| 1.0 + i as f64)
        .collect();
    let clustering = Clustering::new().clusters(30);
    let plain = clustering
        .run(&coordinates, dim, Some(&weights))
        .expect("good input");
    for exponent in [-900, -400, 400, 1000] {
        let size = crate::order::split_power(exponent);
        let times = |x: &f64| x * size[0] * size[1];
        let scaled: Vec<_> = coordinates.iter().map(times).collect();
        let heavy: Vec<_> = weights.iter().map(times).collect();
        let found = clustering
            .run(&scaled, dim, Some(&heavy))
            .expect("good input");
        assert_eq!(found.assignment(), plain.assignment());
        let centers: Vec<_> = plain.centers().iter().map(times).collect();
        assert_eq!(found.centers(), centers);
        let sums = found.clusters().iter().zip(plain.clusters());
        sums.for_each(|(a, b)| assert_eq!(a.weight, times(&b.weight)));
    }
}

#[test]
fn extreme_numbers_end() {
    for coordinates in [
        vec![
            f64::MAX,
            f64::MAX,
            -f64::MAX,
            -f64::MAX,
            0.0,
            5e-324,
            1e300,
            -1e-300,
        ],
        vec![5e-324, 0.0, 0.0, 5e-324, 1.5e-323, 1e-322],
        vec![0.0; 6],
        vec![-0.0, 0.0, 0.0, -0.0],
    ] {
        for weights in [[1.0, 1.0, 1.0, 1.0], [f64::MAX, f64::MAX, 5e-324, 1.0]] {
            let weights = Some(&weights[..coordinates.len() / 2]);
            let clusters = Clustering::new()
                .run(&coordinates, 2, weights)
                .expect("good input");
            assert!(clusters.len() <= coordinates.len() / 2);
            assert!(
                clusters.centers().iter().all(|x| x.is_finite()),
                "{clusters:?}"
            );
        }
    }
}

#[test]
fn an_error_is_enough() {
    let (_, dim, coordinates) = awkward().swap_remove(0);
    let clusters = Clustering::new()
        .max_error(0.01)
        .run(&coordinates, dim, None)
        .expect("good");
    let history = clusters.history();
    let (last, before) = history.split_last().expect("some");
    assert!(last.worst <= 0.01 && before.iter().all(|e| e.worst > 0.01));
    assert!(history.iter().all(|e| e.mean <= e.worst * (1.0 + 1e-12)));
    let none = Clustering::new()
        .max_error(f64::INFINITY)
        .run(&coordinates, dim, None);
    assert_eq!(none.expect("good").len(), 1);
}

/// By hand: the mean is (3, 1), the deviations along x are 16, 4, 4, 16 and along y 4 × 1.
#[test]
fn the_axis_of_largest_deviation_is_cut() {
    let points = [(-1.0, 0.0), (1.0, 2.0), (5.0, 0.0), (7.0, 2.0)].map(Point::from);
    let mut log = Log::new("clusters", points.to_vec());
    let clusters = Clustering::new()
        .clusters(2)
        .observe(&points, None, &mut log)
        .expect("good");
    let seen: Vec<_> = log.steps.iter().map(|step: &Step| step.event).collect();
    let at = |x, y| Some(Point::new(x, y));
    let moved = |cluster, from, to| Event::ClusterMoved { cluster, from, to };
    assert_eq!(
        seen,
        [
            moved(0, None, at(3.0, 1.0)),
            Event::ClusterSplit {
                clusters: [0, 1],
                cut: Cut::Vertical(3.0)
            },
            moved(0, at(3.0, 1.0), at(0.0, 1.0)),
            moved(1, None, at(6.0, 1.0)),
        ]
    );
    assert_eq!(clusters.assignment(), [0, 0, 1, 1]);
    assert_eq!(
        clusters.history()[0],
        Errors {
            worst: 11.0,
            mean: 11.0
        }
    );
    assert_eq!(
        clusters.clusters()[1],
        Cluster {
            points: 2,
            weight: 2.0,
            error: 2.0
        }
    );
}

#[test]
fn centers_play_forwards_and_backwards() {
    let (_, _, coordinates) = awkward().swap_remove(4);
    let points: Vec<_> = coordinates
        .chunks(2)
        .map(|p| Point::new(p[0], p[1]))
        .collect();
    let mut log = Log::new("clusters", points.to_vec());
    let clusters = Clustering::new()
        .clusters(20)
        .observe(&points, None, &mut log)
        .expect("good");
    let scene = log.last_scene().expect("centers are where they were");
    let centers: Vec<_> = scene.clusters().flat_map(|(_, p)| [p.x, p.y]).collect();
    assert_eq!(centers, clusters.centers());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let run = |c: Clustering, coordinates: &[f64], dim, weights: Option<&[f64]>| {
        let error = c.run(coordinates, dim, weights).expect_err("nonsense");
        error.to_string()
    };
    let plain = Clustering::new();
    let good = [0.0, 1.0];
    assert!(run(plain.clusters(0), &good, 1, None).contains("clusters is 0"));
    for wrong in [-1.0, f64::NAN] {
        assert!(run(plain.max_error(wrong), &good, 1, None).contains("must not be negative"));
    }
    assert!(run(plain, &good, 0, None).contains("dimension of points is 0"));
    assert!(run(plain, &good, 3, None).contains("multiple"));
    assert!(run(plain, &[0.0, 1.0, f64::NAN, 0.0], 2, None).contains("at point 1 is NaN"));
    assert!(run(plain, &good, 1, Some(&[1.0])).contains("1 weights given for 2"));
    for wrong in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(run(plain, &good, 1, Some(&[1.0, wrong])).contains("weight of point 1"));
    }
    let none = plain.clusters(3).run(&[], 2, None).expect("nothing");
    assert!(none.is_empty() && none.history().is_empty());
}

#[test]
fn it_can_be_stopped() {
    struct Impatient(AtomicU64);
    impl Watch for Impatient {
        fn progress(&self, phase: Phase, done: u64, total: u64) {
            assert!(phase == Phase::Cluster && done <= total);
            self.0.store(done, Relaxed);
        }
        fn is_cancelled(&self) -> bool {
            self.0.load(Relaxed) >= 5
        }
    }
    let (_, dim, coordinates) = awkward().swap_remove(0);
    let watch = Impatient(AtomicU64::new(0));
    let stopped = Clustering::new().watch(&watch).run(&coordinates, dim, None);
    assert_eq!(stopped, Err(Error::Cancelled));
    assert_eq!(watch.0.into_inner(), 5);
}
