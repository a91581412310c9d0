//! What the chapter claims of its parts, as far as the means of many random sets bear it out. The example
//! `chapter_claims` prints more of them.

use delone_testkit::claims::{compare, share_that_b_finishes};
use delone_testkit::fuzz::cover::Covering;

const SETS: usize = 60;

/// Example 3.51.
#[test]
fn optimization_makes_angles_larger() {
    let without = Covering {
        optimizes: false,
        ..Covering::default()
    };
    for (n, least) in [(150, 3), (300, 6)] {
        let found = compare(SETS, n, least, [&Covering::default(), &without]);
        assert!(found.min_angle[0] > found.min_angle[1], "{found:?}");
        assert!(found.better[0] > 2.0 * found.better[1], "{found:?}");
    }
}

/// Example 3.52: 150 data, d = 3.
#[test]
fn algorithm_b_makes_angles_larger_than_c_alone_and_more_triangles() {
    let without = Covering {
        divides_edges: false,
        ..Covering::default()
    };
    let found = compare(SETS, 150, 3, [&Covering::default(), &without]);
    assert!(found.min_angle[0] > found.min_angle[1], "{found:?}");
    assert!(found.better[0] > found.better[1], "{found:?}");
    assert!(found.triangles[0] > found.triangles[1], "{found:?}");
}

/// Example 3.53: inner points spare outer ones, and Algorithm A makes more triangles.
///
/// That what comes of it after Algorithm B is often better is not borne out: the smallest angle is smaller in the mean.
#[test]
fn inner_points_spare_outer_ones() {
    let chapter = Covering {
        divides_edges: false,
        divides_triangles: false,
        ..Covering::default()
    };
    let without = Covering {
        inner_points: false,
        ..chapter.clone()
    };
    let found = compare(2 * SETS, 150, 6, [&chapter, &without]);
    assert!(found.reductions[1] > 1.5 * found.reductions[0], "{found:?}");
    assert!(found.triangles[0] > 1.5 * found.triangles[1], "{found:?}");
}

/// After Algorithm B no triangle holds 3d data or more, in most cases.
#[test]
fn algorithm_c_has_seldom_anything_to_do() {
    assert!(share_that_b_finishes(SETS, 150, 3) > 0.5);
    assert!(share_that_b_finishes(SETS, 150, 6) > 0.8);
}
