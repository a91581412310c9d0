//! Scripts of edits, which the test kit compares step by step with what is made from scratch, with their
//! vertices, constraints, chains and refusals.

use delone::Point;
use delone_testkit::fuzz::Case;
use delone_testkit::fuzz::edit::{Edit, Script, case, check};
use delone_testkit::generate::{Kind, Random};

fn require(script: &Script) {
    if let Err(reason) = check(script) {
        panic!("{reason}\n{}", script.as_source());
    }
}

fn points(coordinates: &[(f64, f64)]) -> Vec<Point> {
    coordinates.iter().map(|&p| p.into()).collect()
}

/// Inserts points, then removes all vertices in some order, then inserts them again.
fn down_and_up(start: &[Point], r: &mut Random) {
    let mut edits: Vec<_> = (0..start.len())
        .map(|_| Edit::Remove(r.below(1 << 16)))
        .collect();
    // Some more: from nothing nothing can be removed.
    edits.extend([Edit::Remove(0), Edit::Remove(1)]);
    let mut again = start.to_vec();
    r.shuffle(&mut again);
    edits.extend(again.into_iter().map(Edit::Insert));
    let start = start.to_vec();
    require(&Script { start, edits });
}

#[test]
fn every_kind_of_points_goes_down_to_nothing_and_up_again() {
    for kind in Kind::ALL {
        for seed in 0..6 {
            let mut r = Random::new(seed);
            down_and_up(&kind.points(30, seed), &mut r);
        }
    }
}

#[test]
fn every_kind_of_points_is_moved_about() {
    for kind in Kind::ALL {
        for seed in 0..6 {
            let r = &mut Random::new(seed);
            let edits = kind.points(40, seed + 100).into_iter();
            let edits = edits.map(|p| Edit::Move(r.below(1 << 16), p)).collect();
            let start = kind.points(20, seed);
            require(&Script { start, edits });
        }
    }
}

#[test]
fn random_scripts_on_lattices_and_worse() {
    let mut script = Script::default();
    for seed in 0..1500 {
        case(seed, 16, 40, &mut script);
        require(&script);
    }
}

/// Rows: all on one line, at any slope, with constraints upon it and points off it for a while.
#[test]
fn a_row_is_edited_at_its_ends_inside_and_off_it() {
    for (dx, dy) in [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (-3.0, 1.0)] {
        let at = |t: f64| Point::new(dx * t, dy * t);
        let start: Vec<_> = (0..6).map(|t| at(f64::from(t))).collect();
        let edits = vec![
            Edit::Insert(at(2.5)),
            Edit::Insert(at(-1.0)),
            Edit::Insert(at(9.0)),
            Edit::Constrain(0, 4),
            Edit::Constrain(2, 8),
            Edit::Remove(1),
            Edit::Remove(3),
            Edit::Remove(0),
            Edit::Move(0, at(4.5)),
            Edit::Move(0, Point::new(1.0, 2.0)),
            Edit::Move(0, at(20.0)),
            Edit::Release(0),
            Edit::Release(0),
            Edit::Insert(Point::new(100.0, 3.0)),
            Edit::Remove(8),
            Edit::Remove(7),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Remove(0),
            Edit::Insert(at(3.0)),
        ];
        require(&Script { start, edits });
    }
}

#[test]
fn a_vertex_on_the_hull_leaves_pockets_and_straight_edges() {
    // Five on the lower side, a crown above; every vertex once the first to go.
    let start = points(&[
        (0.0, 0.0),
        (1.0, 0.0),
        (2.0, 0.0),
        (3.0, 0.0),
        (4.0, 0.0),
        (2.0, 9.0),
        (1.0, 2.0),
        (2.0, 3.0),
        (3.0, 2.0),
        (2.0, 1.0),
    ]);
    for first in 0..start.len() {
        for second in 0..start.len() - 1 {
            let edits = vec![Edit::Remove(first), Edit::Remove(second), Edit::Remove(0)];
            require(&Script {
                start: start.clone(),
                edits,
            });
        }
    }
}
