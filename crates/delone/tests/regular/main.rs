//! Regular triangulations against the definition, against rational arithmetic, and against themselves in
//! other orders.

mod definition;
mod diagram;
mod rational;
mod results;
mod sites;

use delone::regular::{self, Regular};
use delone::{Point, VertexId};

/// A point and its weight.
type Site = (Point, f64);

fn built(sites: &[Site]) -> Regular {
    let t = regular::triangulate(sites.iter().copied()).expect("finite sites");
    t.triangulation().mesh().validate().expect("a sphere");
    t
}

/// The triangles, each with its smallest corner first, sorted.
fn triangles(t: &Regular) -> Vec<[usize; 3]> {
    let rows = t.triangulation().triangles().iter();
    let mut rows: Vec<_> = rows.map(|row| turned(row.map(VertexId::index))).collect();
    rows.sort_unstable();
    rows
}

fn turned(mut row: [usize; 3]) -> [usize; 3] {
    let least = (0..3).min_by_key(|&k| row[k]).expect("three corners");
    row.rotate_left(least);
    row
}

fn hidden(t: &Regular) -> Vec<usize> {
    t.hidden().iter().map(|v| v.index()).collect()
}

/// The hull, beginning with its lowest number.
fn hull(t: &Regular) -> Vec<usize> {
    let mut hull: Vec<_> = t.triangulation().hull().map(VertexId::index).collect();
    if let Some(least) = (0..hull.len()).min_by_key(|&i| hull[i]) {
        hull.rotate_left(least);
    }
    hull
}
