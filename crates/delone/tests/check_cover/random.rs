//! Data of all kinds, and what becomes of covers by chance, against the naive judge.

use super::cover::Cover;
use super::judge::is_right;
use delone::check::Defect;
use delone::{Point, TriangleId, VertexId};
use delone_testkit::data::{DataKind, data};
use delone_testkit::generate::{Kind, Random};
use delone_testkit::naive::{naive_largest_least, triangles_at};

/// Delaunay triangles on the corners of a box around the data and on a few of these, data shared out; `None` if all
/// are on one line.
fn around(data: Vec<Point>, inner: usize, random: &mut Random) -> Option<Cover> {
    let least = |f: fn(&Point) -> f64| data.iter().map(f).fold(f64::INFINITY, f64::min);
    let most = |f: fn(&Point) -> f64| data.iter().map(f).fold(f64::NEG_INFINITY, f64::max);
    let [left, right] = [least(|p| p.x), most(|p| p.x)];
    let [bottom, top] = [least(|p| p.y), most(|p| p.y)];
    let corners = [(left, bottom), (right, bottom), (right, top), (left, top)];
    let mut points: Vec<Point> = corners.map(Point::from).to_vec();
    points.extend((0..inner).map(|_| data[random.below(data.len())]));
    let t = delone::triangulate(points).expect("finite");
    if t.triangles().is_empty() {
        return None;
    }
    // Duplicates among the vertices are none.
    let mut number = vec![None; t.points().len()];
    let mut points = Vec::new();
    let mut renumber = |v: VertexId| {
        *number[v.index()].get_or_insert_with(|| {
            points.push(t.points()[v.index()]);
            VertexId::new(points.len() - 1)
        })
    };
    let triangles = t.triangles().iter().map(|t| t.map(&mut renumber)).collect();
    let cover = Cover {
        points,
        triangles,
        ..Cover::bare(&[], &[])
    };
    Some(cover.fed(data))
}

#[test]
fn data_of_all_kinds() {
    for kind in DataKind::ALL {
        for seed in 0..6 {
            let mut random = Random::new(seed);
            let n = 20 + random.below(60);
            let inner = random.below(6);
            let Some(mut cover) = around(data(kind, n, seed), inner, &mut random) else {
                continue;
            };
            let found = cover.certificate();
            assert!(is_right(&cover), "{kind:?} {seed}");
            assert_eq!(found.triangles, 2 * found.vertices - found.border_edges - 2);
            assert_eq!(found.data + found.duplicates, n);
            assert!(found.fewest >= cover.least && found.fewest <= found.most);
            let too_many = found.histogram.iter().skip((3 * cover.least).max(1));
            let too_many: usize = too_many.sum();
            assert_eq!(
                found.special.len(),
                if cover.least > 0 { too_many } else { 0 }
            );
            cover.least += 1;
            cover.refuses(|defect| matches!(defect, Defect::TooFewData { .. }));
        }
    }
}

/// Changes one thing.
fn mutate(cover: &mut Cover, random: &mut Random) {
    let t = random.below(cover.triangles.len());
    let (k, v) = (random.below(3), random.below(cover.points.len()));
    let [datum, other] = [0; 2].map(|_| random.below(cover.data.len()));
    match random.below(8) {
        0 => cover.triangles[t][k] = VertexId::new(v),
        1 => cover.triangles[t].swap(k, (k + 1) % 3),
        2 => {
            // Holders of the last triangle hold on to what takes its place.
            cover.triangles.swap_remove(t);
            let last = TriangleId::new(cover.triangles.len().max(1) - 1);
            cover.holders.iter_mut().for_each(|h| *h = last.min(*h));
        }
        3 => cover.triangles.push(cover.triangles[t]),
        4 => cover.points[v] = cover.data[datum],
        5 => cover.holders[datum] = TriangleId::new(t),
        6 => cover.data[datum] = cover.data[other],
        _ => cover.data[datum] = cover.points[v],
    }
}

/// Gives all data to triangles that contain them, where there are any: mutations of the triangles alone are tested.
fn settle(cover: &mut Cover) {
    for (datum, &at) in cover.data.iter().enumerate() {
        if let Some(&t) = triangles_at(&cover.points, &cover.triangles, at).first() {
            cover.holders[datum] = TriangleId::new(t);
        }
    }
    cover.least = 0;
}

#[test]
fn the_judge_agrees_about_mutants() {
    let mut random = Random::new(11);
    let mut rights = 0;
    for round in 0..3_000 {
        let kind = random.choose(&[
            Kind::Lattice { side: 5 },
            Kind::Lattice { side: 20 },
            Kind::Uniform,
            Kind::UlpLattice,
            Kind::HugeOffset,
        ]);
        let n = 8 + random.below(12);
        let inner = random.below(7);
        let Some(mut cover) = around(kind.points(n, random.bits()), inner, &mut random) else {
            continue;
        };
        mutate(&mut cover, &mut random);
        if cover.triangles.is_empty() {
            continue;
        }
        if random.below(2) == 0 {
            settle(&mut cover);
        }
        let is_proper = |t: &[VertexId; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let expected = cover.triangles.iter().all(is_proper) && is_right(&cover);
        let found = cover.verify();
        assert_eq!(found.is_ok(), expected, "{round}: {found:?}\n{cover:?}");
        rights += usize::from(expected);
    }
    // Some mutations do no harm.
    assert!((300..2_000).contains(&rights), "{rights}");
}

#[test]
fn random_triangles_on_a_small_lattice() {
    let mut random = Random::new(5);
    let mut rights = 0;
    for _ in 0..20_000 {
        let mut points: Vec<Point> = Kind::Lattice { side: 3 }.points(5, random.bits());
        points.sort_by(Point::lex_cmp);
        points.dedup();
        let n = points.len();
        let triangles: Vec<_> = (0..1 + random.below(4))
            .map(|_| [0; 3].map(|_| VertexId::new(random.below(n))))
            .collect();
        let cover = Cover {
            points,
            triangles,
            ..Cover::bare(&[], &[])
        };
        let is_proper = |t: &[VertexId; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let expected = cover.triangles.iter().all(is_proper) && is_right(&cover);
        assert_eq!(cover.verify().is_ok(), expected, "{cover:?}");
        rights += usize::from(expected);
    }
    assert!(rights > 0, "{rights}");
}

#[test]
fn what_the_oracle_says_is_the_most() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let Some(cover) = around(Kind::Lattice { side: 5 }.points(25, seed), 3, &mut random) else {
            continue;
        };
        let most = naive_largest_least(&cover.points, &cover.triangles, &cover.data);
        assert_eq!(most, Some(cover.least));
        assert!(cover.certificate().fewest == cover.least);
    }
}
