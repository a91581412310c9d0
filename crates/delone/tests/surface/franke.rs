//! Errors on Franke's function, against those that others have measured.

#[path = "../../examples/franke_errors.rs"]
#[allow(dead_code, reason = "the test has no use for `main`")]
mod franke_errors;

use delone::Point;
use delone::surface::FitOptions;
use delone_testkit::cover;
use franke_errors::{Errors, Nodes, all_nodes, errors_between, errors_of_fits, table};

/// Returns what SciPy has measured.
fn known(nodes: &Nodes, method: &str) -> Errors {
    let text = include_str!("../data/franke/baselines.json");
    let known: serde_json::Value = serde_json::from_str(text).expect("errors");
    let known = &known["results"][nodes.name][method];
    let number = |i: usize| known[i].as_f64().expect("a number");
    Errors {
        max: number(0),
        rms: number(1),
        points: number(3) as usize,
    }
}

/// The linear surface is the same but for diagonals of cocircular nodes, as Franke's 33 have them. SciPy's elements of
/// Clough and Tocher differ from ours across edges, so that only the size of errors agrees.
#[test]
fn interpolants_err_as_others_do() {
    for nodes in all_nodes() {
        let [linear, smooth] = errors_between(&nodes.points).expect("errors");
        let name = nodes.name;
        let expected = known(&nodes, "linear");
        assert_eq!(linear.points, expected.points, "{name}");
        assert!(
            (linear.rms - expected.rms).abs() < 2e-5,
            "{name} {linear:?}"
        );
        assert!(
            (linear.max - expected.max).abs() < 2e-5,
            "{name} {linear:?}"
        );
        let expected = known(&nodes, "clough-tocher scipy");
        assert_eq!(smooth.points, expected.points, "{name}");
        assert!(
            (smooth.rms - expected.rms).abs() < 2e-3,
            "{name} {smooth:?}"
        );
        assert!(
            (smooth.max - expected.max).abs() < 2e-2,
            "{name} {smooth:?}"
        );
    }
}

/// The smaller triangles are, the better cubics fit.
#[test]
fn fits_err_little_where_data_are_many() {
    let domain = [0.0, 1.0].map(|c| Point::new(c, c));
    let data = cover::halton(1500);
    let mut last = f64::INFINITY;
    for side in [2, 4, 7] {
        let t = cover::lattice(domain, side, &data, 10).expect("enough data");
        let (errors, summary) = errors_of_fits(&t, FitOptions::degree(3)).expect("fits");
        assert_eq!(errors.points, 33 * 33);
        assert!(errors.rms < last / 2.0, "{side}: {errors:?} {summary:?}");
        last = errors.rms;
    }
}

#[test]
fn the_table_has_a_row_for_each_set_of_nodes() {
    let cover = |data: &[Point], domain, least| cover::lattice(domain, 1, data, least).ok();
    let table = table(&cover).expect("a table");
    assert_eq!(table.lines().count(), 2 + 5, "{table}");
    assert!(
        table.lines().all(|line| line.matches('|').count() == 7),
        "{table}"
    );
    assert!(!table.contains("NaN") && !table.contains("inf"), "{table}");
}
