//! The search against itself, with and without a forecast, and its places against closed triangles.

use super::*;
use crate::Point;
use crate::predicates::{Orientation, cross_properly, orient2d};
use proptest::prelude::*;

/// Triangles `abc` and bad, in coordinates that data are given in as well.
const SHAPES: [[(f64, f64); 4]; 5] = [
    // a, b, c, d
    [(0.0, 0.0), (8.0, 0.0), (4.0, 6.0), (4.0, -6.0)],
    [(0.0, 0.0), (8.0, 0.0), (1.0, 8.0), (7.0, -2.0)],
    // Not convex at b.
    [(0.0, 0.0), (4.0, 0.0), (8.0, 8.0), (8.0, -8.0)],
    // A needle, and a square.
    [(0.0, 0.0), (8.0, 1.0), (5.0, 0.75), (3.0, 0.25)],
    [(0.0, 0.0), (8.0, 8.0), (0.0, 8.0), (8.0, 0.0)],
];

/// Moves a plot and its data together: nothing may depend on it, but for rounding.
const FRAMES: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [1.0, 0.1, 0.7],
    [0.37, 1e6, -1e6],
    [1e200, 0.0, 0.0],
    [1e-200, 0.0, 0.0],
    [5e-324, 0.0, 0.0],
];

fn framed([scale, x, y]: [f64; 3], (p, q): (f64, f64)) -> Point {
    Point::new(scale * p + x, scale * q + y)
}

fn is_in(corners: [Point; 3], p: Point) -> bool {
    let [a, b, c] = corners;
    [[a, b], [b, c], [c, a]]
        .into_iter()
        .all(|[from, to]| orient2d(from, to, p) != Orientation::Right)
}

fn silent(plot: &Plot, least: usize, bisections: u32) -> Option<Found> {
    search(plot, least, bisections, Listener::Nobody)
}

fn told(plot: &Plot, least: usize, bisections: u32) -> (Option<Found>, Vec<(Point, [usize; 4])>) {
    let mut places = Vec::new();
    let mut tell = |at, counts| places.push((at, counts));
    let found = search(plot, least, bisections, Listener::Told(&mut tell));
    (found, places)
}

/// The parts at `t`, as triangles.
fn parts(plot: &Plot, [a, b, c, d]: [Point; 4], t: Point) -> Vec<[Point; 3]> {
    match plot.num_parts() {
        2 => vec![[a, t, c], [t, b, c]],
        _ => vec![[a, t, c], [a, d, t], [d, b, t], [t, b, c]],
    }
}

/// Both ways come to the same; places, counts and shares are what they should be. Tells whether there is a place.
fn require(plot: &Plot, corners: [Point; 4], least: usize, bisections: u32) -> bool {
    let (found, places) = told(plot, least, bisections);
    assert_eq!(found, silent(plot, least, bisections), "{corners:?}");
    assert!(places.len() < bisections.max(1) as usize);
    for &(at, counts) in &places {
        // Or data on an outer edge would be left out.
        let is_outside = orient2d(corners[0], corners[1], at) != Orientation::Left;
        assert!(plot.num_parts() == 4 || is_outside);
        for (triangle, count) in parts(plot, corners, at).into_iter().zip(counts) {
            let [from, to, t] = triangle;
            let is_proper = orient2d(from, to, t) == Orientation::Left;
            let held = plot
                .data
                .iter()
                .filter(|&&p| is_proper && is_in(triangle, p));
            assert_eq!(held.count(), count);
        }
    }
    let Some(found) = found else {
        return false;
    };
    let parts = parts(plot, corners, found.at);
    let mut held = vec![0; parts.len()];
    for (&p, &part) in plot.data.iter().zip(&found.shares) {
        assert!(is_in(parts[part as usize], p));
        held[part as usize] += 1;
    }
    assert!(held.iter().all(|&held| held >= least));
    true
}

/// All plots of two triangles, of whose data there are `of_first` in the first.
fn require_all(corners: [Point; 4], data: &[Point], least: usize, bisections: u32) -> usize {
    let [a, b, c, d] = corners;
    let first: Vec<_> = data
        .iter()
        .copied()
        .filter(|&p| is_in([a, b, c], p))
        .collect();
    let second = data
        .iter()
        .filter(|&&p| !first.contains(&p) && is_in([b, a, d], p));
    let both: Vec<_> = first.iter().copied().chain(second.copied()).collect();
    let mut found = require(&Plot::outer([a, b, c], &first), corners, least, bisections) as usize;
    found += require(&Plot::edge(corners, &both), corners, least, bisections) as usize;
    if cross_properly([a, b], [c, d]) {
        let plot = Plot::diagonal(corners, &both);
        found += require(&plot, corners, least, bisections) as usize;
    }
    found
}

fn is_proper([a, b, c, d]: [Point; 4]) -> bool {
    orient2d(a, b, c) == Orientation::Left && orient2d(b, a, d) == Orientation::Left
}

proptest! {
    #[test]
    fn random_data(
        shape in 0..SHAPES.len(), frame in 0..FRAMES.len(), least in 1usize..8, bisections in 0u32..40,
        raw in prop::collection::vec((-8.0..16.0, -8.0..16.0), 0..200),
    ) {
        let corners = SHAPES[shape].map(|p| framed(FRAMES[frame], p));
        let data: Vec<_> = raw.into_iter().map(|p| framed(FRAMES[frame], p)).collect();
        if is_proper(corners) {
            require_all(corners, &data, least, bisections);
        }
    }

    /// Many data on edges, diagonals, spokes and corners.
    #[test]
    fn lattices(
        shape in 0..SHAPES.len(), frame in 0..FRAMES.len(), least in 1usize..8, bisections in 0u32..40,
        step in 1u8..5, raw in prop::collection::vec((-8i8..=16, -8i8..=16), 0..200),
    ) {
        let step = f64::from(step) / 2.0;
        let corners = SHAPES[shape].map(|p| framed(FRAMES[frame], p));
        let mut data: Vec<_> = raw
            .into_iter()
            .map(|(x, y)| framed(FRAMES[frame], (f64::from(x) * step, f64::from(y) * step)))
            .collect();
        data.sort_by(Point::lex_cmp);
        data.dedup();
        if is_proper(corners) {
            require_all(corners, &data, least, bisections);
        }
    }

    /// Tracks: data on few lines, some of them along the segment itself.
    #[test]
    fn tracks(
        shape in 0..SHAPES.len(), frame in 0..FRAMES.len(), least in 1usize..8,
        lines in prop::collection::vec(((0usize..4, 0usize..4), prop::array::uniform2(-1e-9..1e-9)), 1..4),
        raw in prop::collection::vec(0.0..1.0, 0..60),
    ) {
        let shape = SHAPES[shape];
        let corners = shape.map(|p| framed(FRAMES[frame], p));
        let mut data = Vec::new();
        for ((from, to), [x, y]) in lines {
            let [(px, py), (qx, qy)] = [shape[from], shape[to]];
            let on = |t: f64| (px + t * (qx - px) + x, py + t * (qy - py) + y);
            data.extend(raw.iter().map(|&t| framed(FRAMES[frame], on(t))));
        }
        if is_proper(corners) {
            require_all(corners, &data, least, 25);
        }
    }
}

#[test]
fn even_data_are_divided_at_every_scale() {
    for frame in &FRAMES[..5] {
        let corners = SHAPES[0].map(|p| framed(*frame, p));
        let lattice = (0..1600).map(|i| (f64::from(i % 40), f64::from(i / 40)));
        let data = lattice.map(|(x, y)| framed(*frame, (0.21 * x, 0.31 * y - 6.0)));
        let data: Vec<_> = data.collect();
        assert_eq!(require_all(corners, &data, 20, 25), 3, "{frame:?}");
    }
}

#[test]
fn all_places_but_the_last_are_forecast() {
    // Data to the right of the middle: the search must go there.
    let corners = SHAPES[0].map(Point::from);
    let spot = |i: i32| {
        (
            5.0 + 0.02 * f64::from(i % 13),
            0.1 * f64::from(i / 13) - 1.0,
        )
    };
    let data: Vec<_> = (0..260).map(|i| Point::from(spot(i))).collect();
    let plot = Plot::edge(corners, &data);
    let forecast = super::forecast::Forecast::new(&plot, 30);
    let (found, places) = told(&plot, 30, 25);
    assert!(found.is_some());
    let known = places.iter().filter(|&&(at, _)| {
        let b = at.x / 8.0;
        forecast.judge(&plot, b, at).is_some()
    });
    assert_eq!(known.count(), places.len() - 1);
}

#[test]
fn nothing_is_found_where_data_lie_on_a_line_across() {
    // The picture of the chapter: all data on one line across a quadrilateral.
    let corners = SHAPES[0].map(Point::from);
    let data: Vec<_> = (0..40)
        .map(|i| Point::new(0.6 + 0.17 * f64::from(i), 0.3))
        .collect();
    assert!(!require(&Plot::diagonal(corners, &data), corners, 10, 25));
}

#[test]
fn fewer_places_than_bisections_are_tried() {
    let corners = SHAPES[0].map(Point::from);
    let data: Vec<_> = (0..40)
        .map(|i| Point::new(1.0, 0.02 * f64::from(i)))
        .collect();
    let plot = Plot::outer([corners[0], corners[1], corners[2]], &data);
    assert_eq!(told(&plot, 10, 0).1.len(), 0);
    assert_eq!(told(&plot, 10, 1).1.len(), 0);
    assert_eq!(told(&plot, 10, 4).1.len(), 3);
}
