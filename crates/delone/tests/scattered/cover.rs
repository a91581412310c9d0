//! What every cover keeps, decided without the library's bookkeeping.

use delone::predicates::{Orientation, orient2d};
use delone::scattered::{Cover, DataTriangulation};
use delone::{Log, Point};

pub fn random(n: u32, seed: u32) -> Vec<Point> {
    let mut state = u64::from(seed) * 2 + 1;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as f64 / f64::from(1u32 << 31)
    };
    (0..n).map(|_| Point::new(next(), next())).collect()
}

/// Each datum lies in the triangle that holds it, and every triangle holds enough.
pub fn require(cover: &DataTriangulation) {
    let verdict = cover.verify(&()).expect("nobody cancels");
    verdict.into_result().expect("a cover");
    for (&p, holder) in cover.data().iter().zip(cover.holders()) {
        let [a, b, c] = cover.triangles()[holder.index()].map(|v| cover.points()[v.index()]);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            assert_ne!(orient2d(from, to, p), Orientation::Right, "{p:?}");
        }
    }
    let named: Vec<_> = cover
        .exceptions()
        .iter()
        .map(|e| e.triangle.index())
        .collect();
    for (t, count) in cover.counts().into_iter().enumerate() {
        assert!(count >= cover.least(), "triangle {t} holds {count}");
        assert!(
            count <= cover.most() || named.contains(&t),
            "triangle {t} holds {count}"
        );
    }
}

#[test]
pub fn random_data_are_covered_and_the_log_can_be_played() {
    for (n, least) in [(40, 1), (60, 3), (150, 6), (200, 10)] {
        let data = random(n, least);
        let mut log = Log::new("cover", data.clone());
        let options = Cover::new(least as usize);
        let cover = options.observe(data.iter().copied(), &mut log).unwrap();
        require(&cover);
        let scene = log.last_scene().unwrap();
        assert_eq!(scene.triangles().count(), cover.triangles().len());
        assert_eq!(
            cover,
            options.cover(data).unwrap(),
            "observed and unobserved"
        );
    }
}

#[test]
fn lattices_are_covered() {
    for least in [1, 2, 5, 9] {
        let lattice = (0..144).map(|i| (f64::from(i % 12), f64::from(i / 12)));
        require(&Cover::new(least).factor(1.0).cover(lattice).unwrap());
    }
}
