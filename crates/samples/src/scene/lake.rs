//! A lake, about 16 by 9 kilometres: drawn by hand as polygons of a few corners each, whose edges
//! are then made into shores.
//!
//! A shore is made by displacing midpoints (Fournier, Fussell, Carpenter, *Computer rendering of
//! stochastic models*, 1982): each edge gets a middle that lies off it by a random part of its
//! length, until pieces are short. A depth contour is made by cutting corners (Chaikin 1974): it is
//! smooth. In the water are soundings on a lattice, each moved a little. Metres are kept, the rest is
//! rounded.

use super::Sheet;
use crate::Random;

/// The markers of the segments.
const SHORE: i32 = 1;
const ISLAND: i32 = 2;
const POND: i32 = 3;
const CONTOUR: i32 = 4;
const BREAKWATER: i32 = 5;
/// Where the river leaves the map.
const RIVER: i32 = 6;

/// The attributes of the regions.
const SHALLOW: f64 = 1.0;
const DEEP: f64 = 2.0;
const POND_WATER: f64 = 3.0;

/// Pieces of shore are at most this long, in kilometres.
const STEP: f64 = 0.22;

/// How far a middle may lie off its edge, in lengths of the edge.
const ROUGH: f64 = 0.25;
/// The banks of the river are close to each other and must not meet.
const SMOOTH: f64 = 0.06;

/// The shore from the north bank of the river around to its south bank, counter-clockwise.
const OUTLINE: [[f64; 2]; 24] = [
    [14.5, 4.95],
    [13.2, 6.5],
    [11.6, 7.1],
    [11.0, 8.6],
    [8.7, 9.0],
    [8.0, 7.5],
    [7.2, 6.0],
    [6.7, 7.5],
    [5.2, 8.5],
    [3.2, 7.7],
    [2.6, 6.2],
    [0.9, 5.6],
    [0.5, 3.6],
    [2.0, 2.5],
    [3.5, 2.6],
    [4.2, 1.0],
    [6.5, 0.4],
    [7.6, 2.2],
    [8.8, 1.9],
    [9.6, 0.6],
    [12.0, 0.5],
    [12.7, 2.0],
    [14.0, 2.6],
    [14.5, 4.4],
];

/// The banks of the river, upstream and back.
const SOUTH_BANK: [[f64; 2]; 4] = [[14.9, 4.35], [15.5, 4.55], [16.1, 4.2], [16.7, 4.25]];
const NORTH_BANK: [[f64; 2]; 4] = [[16.7, 4.5], [16.1, 4.45], [15.5, 4.85], [14.9, 4.7]];

/// The islands.
const ISLANDS: [&[[f64; 2]]; 6] = [
    &[
        [8.9, 4.2],
        [10.0, 3.4],
        [11.3, 4.0],
        [11.9, 5.3],
        [10.9, 6.0],
        [9.6, 5.4],
    ],
    &[[3.3, 4.3], [4.0, 3.9], [5.0, 4.4], [4.6, 4.9], [3.7, 4.8]],
    &[[5.5, 1.6], [6.3, 1.4], [6.5, 2.1], [5.9, 2.2]],
    &[[12.5, 3.1], [13.1, 3.4], [13.1, 4.2], [12.6, 3.9]],
    &[[4.0, 6.9], [4.9, 6.7], [5.2, 7.2], [4.4, 7.5]],
    &[[9.2, 7.1], [9.8, 7.0], [10.1, 7.9], [9.4, 8.2]],
];

/// A point on the land of each island: that of the first one is no middle, for there is the pond.
const LAND: [[f64; 2]; 6] = [
    [9.5, 4.6],
    [4.1, 4.5],
    [6.1, 1.8],
    [12.8, 3.6],
    [4.6, 7.1],
    [9.6, 7.5],
];

/// The pond on the first island.
const POND_SHORE: [[f64; 2]; 4] = [[10.2, 4.3], [10.9, 4.4], [11.1, 5.1], [10.4, 4.9]];

/// Where the water is deep.
const BASIN: [[f64; 2]; 12] = [
    [1.5, 4.4],
    [2.6, 3.4],
    [4.3, 3.3],
    [5.6, 2.7],
    [7.0, 3.0],
    [8.2, 3.2],
    [8.3, 4.4],
    [7.3, 4.7],
    [6.4, 5.9],
    [5.0, 5.6],
    [3.6, 6.3],
    [2.4, 5.7],
];

/// A breakwater off the southern shore.
const BREAKWATER_LINE: [[f64; 2]; 4] = [[12.5, 2.15], [12.3, 2.2], [12.0, 2.15], [11.8, 2.0]];

/// Soundings lie about so far from each other, and at least half as far from anything drawn.
const SPACING: f64 = 0.6;
/// How far each is moved from its place on the lattice.
const JITTER: f64 = 0.15;
/// The lattice begins here and has so many columns and rows.
const SOUNDINGS: ([f64; 2], [u32; 2]) = ([0.3, 0.3], [27, 16]);

/// Draws the lake.
pub(super) fn draw() -> Sheet {
    let random = &mut Random::new(9);
    let mut lake = Sheet::default();
    draw_shore(&mut lake, random);
    for island in ISLANDS {
        lake.add_ring(ISLAND, rounded(rough_ring(island, ROUGH, random)));
    }
    lake.add_ring(POND, rounded(rough_ring(&POND_SHORE, ROUGH, random)));
    lake.add_ring(CONTOUR, rounded(cut_corners(cut_corners(BASIN.into()))));
    lake.add_line(BREAKWATER, BREAKWATER_LINE);
    let soundings = soundings(&lake, random);
    lake.points.extend(soundings);
    lake.holes.extend(LAND);
    let places = [[13.0, 5.5], [6.5, 4.5], [10.7, 4.7]];
    lake.regions
        .extend(places.into_iter().zip([SHALLOW, DEEP, POND_WATER]));
    lake
}

/// Draws the shore with the river; the last piece, where the map ends, has a marker of its own.
fn draw_shore(lake: &mut Sheet, random: &mut Random) {
    let ends = [NORTH_BANK[3], OUTLINE[0]];
    let mouth = [OUTLINE[OUTLINE.len() - 1], SOUTH_BANK[0]];
    let pieces = [
        rough_line(&NORTH_BANK, SMOOTH, random),
        rough_line(&ends, SMOOTH, random),
        rough_line(&OUTLINE, ROUGH, random),
        rough_line(&mouth, SMOOTH, random),
        rough_line(&SOUTH_BANK, SMOOTH, random),
    ];
    let mut shore = pieces.concat();
    // Pieces share their ends.
    shore.dedup();
    lake.add_ring(SHORE, rounded(shore));
    if let Some(last) = lake.markers.last_mut() {
        *last = RIVER;
    }
}

/// Chooses the places on a jittered lattice that lie in the water, off its borders.
fn soundings(lake: &Sheet, random: &mut Random) -> Vec<[f64; 2]> {
    let (origin, [columns, rows]) = SOUNDINGS;
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
    let mut jitter = || random.between(-JITTER, JITTER);
    let jittered: Vec<_> = places
        .map(|place| [0, 1].map(|k| origin[k] + SPACING * f64::from(place[k]) + jitter()))
        .collect();
    let is_free = |p: &[f64; 2]| lake.points.iter().all(|&q| distance(*p, q) > SPACING / 2.0);
    let in_water = jittered
        .into_iter()
        .filter(is_free)
        .filter(|p| is_wet(lake, *p));
    rounded(in_water.collect()).collect()
}

/// Tells whether an odd number of shores lies to the right of a place.
fn is_wet(lake: &Sheet, [x, y]: [f64; 2]) -> bool {
    let is_shore = |marker| matches!(marker, SHORE | RIVER | ISLAND | POND);
    let shores = lake.segments.iter().zip(&lake.markers);
    let to_the_right = shores.filter(|(ends, marker)| {
        let [a, b] = ends.map(|v| lake.points[v as usize]);
        let meets = is_shore(**marker) && (a[1] > y) != (b[1] > y);
        meets && a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > x
    });
    to_the_right.count() % 2 == 1
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [dx, dy] = [0, 1].map(|k| b[k] - a[k]);
    (dx * dx + dy * dy).sqrt()
}

/// Makes a rough line through the corners, both ends included.
fn rough_line(corners: &[[f64; 2]], rough: f64, random: &mut Random) -> Vec<[f64; 2]> {
    let mut line = Vec::new();
    for ends in corners.windows(2) {
        line.extend(rough_edge([ends[0], ends[1]], rough, random));
    }
    line.extend(corners.last());
    line
}

/// Makes a rough ring through the corners.
fn rough_ring(corners: &[[f64; 2]], rough: f64, random: &mut Random) -> Vec<[f64; 2]> {
    let closed: Vec<_> = corners.iter().chain(&corners[..1]).copied().collect();
    let mut ring = rough_line(&closed, rough, random);
    ring.pop();
    ring
}

/// Divides an edge by displaced middles until its pieces are short; the far end is left out.
fn rough_edge([a, b]: [[f64; 2]; 2], rough: f64, random: &mut Random) -> Vec<[f64; 2]> {
    let mut line = vec![a, b];
    let mut length = distance(a, b);
    while length > STEP {
        let mut finer = Vec::with_capacity(2 * line.len());
        for ends in line.windows(2) {
            finer.extend([ends[0], middle([ends[0], ends[1]], rough, random)]);
        }
        finer.push(b);
        line = finer;
        length /= 2.0;
    }
    line.pop();
    line
}

fn middle([a, b]: [[f64; 2]; 2], rough: f64, random: &mut Random) -> [f64; 2] {
    let off = random.between(-rough, rough);
    let along = [b[0] - a[0], b[1] - a[1]];
    [
        (a[0] + b[0]) / 2.0 - off * along[1],
        (a[1] + b[1]) / 2.0 + off * along[0],
    ]
}

/// Replaces each corner of a ring by two, a quarter of the edge before and after it.
fn cut_corners(ring: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let next = ring.iter().cycle().skip(1);
    let cut = |(a, b): (&[f64; 2], &[f64; 2])| {
        [0.25, 0.75].map(|t| [0, 1].map(|k| (1.0 - t) * a[k] + t * b[k]))
    };
    ring.iter().zip(next).flat_map(cut).collect()
}

/// Rounds to metres.
fn rounded(points: Vec<[f64; 2]>) -> impl Iterator<Item = [f64; 2]> {
    points
        .into_iter()
        .map(|p| p.map(|c| (c * 1e3).round() / 1e3))
}
