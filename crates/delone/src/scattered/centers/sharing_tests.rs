//! Sites on small lattices, at which centers come and go as no means ever would: ties everywhere, and many centers at
//! one site. Against comparing each datum with each center.

use super::Sites;
use super::share;
use crate::Point;
use crate::predicates::compare_distances;
use delone_testkit::generate::Random;

/// The nearest center, of several the first.
fn nearest(positions: &[Point], p: Point) -> usize {
    let all = 0..positions.len();
    let by = |&c: &usize, &d: &usize| compare_distances(p, positions[c], positions[d]);
    all.min_by(by).expect("a center")
}

#[test]
fn data_go_to_the_first_of_the_nearest_wherever_centers_are() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let side = 2 + random.below(6);
        let mut draw = || Point::new(random.below(side) as f64, random.below(side) as f64);
        // Halves, too, so that data lie on bisectors and in their meetings.
        let all = (0..4 * side * side).map(|i| [i % (2 * side), i / (2 * side)]);
        let data: Vec<Point> = all
            .map(|[x, y]| Point::new(x as f64 / 2.0, y as f64 / 2.0))
            .collect();
        let mut sites = Sites::default();
        let mut positions = vec![draw()];
        let first = sites.enter(0, positions[0]);
        sites.data_of(first).extend(0..data.len() as u32);
        for round in 0..60 {
            let fullest = (0..positions.len()).max_by_key(|&c| sites.data_of_center(c).len());
            let center = if round % 2 == 0 {
                fullest.unwrap_or(0)
            } else {
                round / 2 % positions.len()
            };
            let old = sites.of_center(center);
            if sites.rank(old) != center {
                continue;
            }
            let own = std::mem::take(sites.data_of(old));
            sites.leave(center);
            let a = draw();
            let b = std::iter::repeat_with(&mut draw)
                .find(|&b| b != a)
                .expect("another place");
            positions[center] = a;
            positions.push(b);
            let new = [sites.enter(center, a), sites.enter(positions.len() - 1, b)];
            let halves: (Vec<u32>, Vec<u32>) = own.into_iter().partition(|i| i % 3 == 0);
            share(&mut sites, &data, new, halves.into());
            for center in 0..positions.len() {
                let mut own = sites.data_of_center(center).to_vec();
                own.sort_unstable();
                let is_own = |&i: &u32| nearest(&positions, data[i as usize]) == center;
                let expected: Vec<u32> = (0..data.len() as u32).filter(is_own).collect();
                assert_eq!(own, expected, "seed {seed}, round {round}, center {center}");
            }
        }
    }
}
