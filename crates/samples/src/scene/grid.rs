//! A lattice on which everything degenerate happens at once: cocircular points, collinear ones,
//! segments through vertices, on each other, and across each other.

use super::Sheet;

/// Points along a side. Even, so that the diagonals cross where no lattice point is.
const SIDE: u32 = 8;

/// The markers: outline, segments along rows, through lattice points, across them.
const OUTLINE: i32 = 1;
const ALONG: i32 = 2;
const THROUGH: i32 = 3;
const ACROSS: i32 = 4;

/// The inner segments, from lattice point to lattice point.
const SEGMENTS: [(i32, [u32; 2], [u32; 2]); 10] = [
    // Two that overlap from x = 3 to 5, one that repeats, reversed.
    (ALONG, [0, 2], [5, 2]),
    (ALONG, [3, 2], [7, 2]),
    (ALONG, [2, 5], [2, 7]),
    (ALONG, [2, 7], [2, 5]),
    // Diagonals: each runs through six lattice points, and they cross in the middle.
    (THROUGH, [0, 0], [7, 7]),
    (THROUGH, [0, 7], [7, 0]),
    // A knight's line, which begins inside the outline.
    (THROUGH, [2, 0], [5, 6]),
    // Nearly along a row: past every lattice point, across every diagonal.
    (ACROSS, [0, 3], [7, 4]),
    (ACROSS, [0, 4], [7, 3]),
    // No length at all.
    (ACROSS, [6, 1], [6, 1]),
];

/// Draws the lattice, row by row, with its outline and the segments.
pub(super) fn draw() -> Sheet {
    let mut sheet = Sheet::default();
    let places = (0..SIDE * SIDE).map(|i| [i % SIDE, i / SIDE].map(f64::from));
    sheet.points.extend(places);
    let vertex = |[x, y]: [u32; 2]| y * SIDE + x;
    let last = SIDE - 1;
    let corners = [[0, 0], [last, 0], [last, last], [0, last]];
    for (i, &corner) in corners.iter().enumerate() {
        let next = corners[(i + 1) % corners.len()];
        sheet.add_segment(OUTLINE, [corner, next].map(vertex));
    }
    for (marker, from, to) in SEGMENTS {
        sheet.add_segment(marker, [from, to].map(vertex));
    }
    sheet
}
