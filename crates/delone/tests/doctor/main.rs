//! The doctor: what he finds against brute force and the corpus, what he repairs against his promises.

mod examine;
mod large;
mod repair;

use delone::doctor::{Diagnosis, Doctor, Repair};
use delone::predicates::{CircleSide, in_disc, is_near_segment};
use delone::{Point, Pslg, VertexId};
use delone_testkit::generate::Random;

const ALL: usize = 1 << 20;

fn examine(pslg: &Pslg, tolerance: f64) -> Diagnosis {
    let doctor = Doctor::new().tolerance(tolerance).limit(ALL);
    doctor.examine(pslg).expect("a drawing without mistakes")
}

fn repair(pslg: &Pslg, tolerance: f64) -> Repair {
    let doctor = Doctor::new().tolerance(tolerance);
    doctor.repair(pslg).expect("a drawing without mistakes")
}

/// Points and segments at random in the unit square, some points near others.
fn scattered(random: &mut Random, points: usize, segments: usize, near: f64) -> Pslg {
    let mut list: Vec<Point> = Vec::new();
    for i in 0..points {
        let [x, y] = [0; 2].map(|_| random.below(1 << 20) as f64 / f64::from(1 << 20));
        let p = match i % 3 {
            2 => {
                let other = list[random.below(list.len())];
                Point::new(other.x + near * (x - 0.5), other.y + near * (y - 0.5))
            }
            _ => Point::new(x, y),
        };
        list.push(p);
    }
    let mut pslg = Pslg::from_points(list);
    for _ in 0..segments {
        let [a, b] = [0; 2].map(|_| random.below(points) as u32);
        pslg.add_segment(a, b);
    }
    pslg
}

/// The same drawing, its points and segments in another order, segments turned round.
fn shuffled(pslg: &Pslg, random: &mut Random) -> Pslg {
    let mut order: Vec<usize> = (0..pslg.points.len()).collect();
    for i in (1..order.len()).rev() {
        order.swap(i, random.below(i + 1));
    }
    let mut number = vec![0; order.len()];
    for (new, &old) in order.iter().enumerate() {
        number[old] = new;
    }
    let mut segments = pslg.segments.clone();
    for i in (1..segments.len()).rev() {
        segments.swap(i, random.below(i + 1));
    }
    for ends in &mut segments {
        *ends = ends.map(|v| VertexId::new(number[v.index()]));
        if random.below(2) == 0 {
            ends.reverse();
        }
    }
    Pslg {
        segments,
        ..Pslg::from_points(order.iter().map(|&old| pslg.points[old]))
    }
}

fn is_within(p: Point, q: Point, radius: f64) -> bool {
    in_disc(p, radius, q) != CircleSide::Outside
}

/// Requires what a repair promises, without a look at how it was made.
fn require_promises(input: &Pslg, repair: &Repair, tolerance: f64) {
    let out = &repair.pslg;
    let facts = out.facts(0, &()).expect("a drawing without mistakes");
    assert!(facts.is_clean(), "{facts:?}");
    assert_eq!(facts.duplicates.count, 0);
    assert_eq!(facts.zero_length.count, 0);
    if input.polygons.is_empty() {
        assert_eq!(facts.repeated.count, 0);
    }
    for (p, v) in input.points.iter().zip(&repair.vertex_of) {
        let q = out.points[v.index()];
        assert!(is_within(*p, q, tolerance), "{p:?} moved to {q:?}");
    }
    // A point of the result is one of the input, unmoved, or a cut.
    for (p, source) in out.points.iter().zip(&repair.sources) {
        if let Some(source) = source {
            assert_eq!(*p, input.points[source.index()]);
        }
    }
    require_chains(input, repair, tolerance);
    let moved = repair.moved().count();
    let differs = |(p, v): (&Point, &VertexId)| *p != out.points[v.index()];
    let expected = input
        .points
        .iter()
        .zip(&repair.vertex_of)
        .filter(|&pair| differs(pair));
    assert_eq!(moved, expected.count());
}

/// Requires that chains join where their segments' ends went, stay near, and are all there is.
fn require_chains(input: &Pslg, repair: &Repair, tolerance: f64) {
    let out = &repair.pslg;
    let at = |v: VertexId| out.points[v.index()];
    let size = input
        .points
        .iter()
        .fold(0.0, |m: f64, p| m.max(p.x.abs()).max(p.y.abs()));
    let reach = 2.0 * tolerance + 64.0 * f64::EPSILON * size + f64::MIN_POSITIVE;
    let mut edges = Vec::new();
    for (ends, chain) in input.segments.iter().zip(&repair.chains) {
        let goal = ends.map(|v| repair.vertex_of[v.index()]);
        assert_eq!(chain.first(), Some(&goal[0]));
        assert_eq!(chain.last(), Some(&goal[1]));
        let before = ends.map(|v| input.points[v.index()]);
        for &v in chain {
            if reach.is_finite() {
                assert!(
                    is_near_segment(before, reach, at(v)),
                    "{before:?} {:?}",
                    at(v)
                );
            }
        }
        edges.extend(chain.windows(2).map(|e| [e[0].min(e[1]), e[0].max(e[1])]));
    }
    let mut listed: Vec<_> = out
        .segments
        .iter()
        .map(|&[a, b]| [a.min(b), a.max(b)])
        .collect();
    for list in [&mut edges, &mut listed] {
        list.sort_unstable();
        list.dedup();
    }
    assert_eq!(listed, edges, "segments are the pieces of chains");
}
