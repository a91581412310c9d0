//! The domain that runs through the examples of a thesis on constrained Delaunay triangulation and
//! refinement (Ulm, 2012), example 1.16, and that of its example 1.33, where a second outline stands
//! beside it. The coordinates of the latter are not printed; ours are like those of the figure's
//! first part: small, and half integers.

use super::Sheet;

/// The marker of the outline.
const OUTLINE: i32 = 1;
/// The marker of the hole's border.
const HOLE: i32 = 2;
/// The marker of the second component.
const SECOND: i32 = 3;

/// Draws example 1.16.
pub(super) fn draw() -> Sheet {
    let mut sheet = Sheet::default();
    let outline = [
        [1.0, 0.0],
        [3.0, 1.0],
        [2.5, 3.0],
        [3.0, 4.0],
        [0.0, 3.0],
        [0.0, 1.0],
    ];
    sheet.add_ring(OUTLINE, outline);
    sheet.add_ring(HOLE, [[2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]);
    sheet.holes.push([1.75, 1.75]);
    sheet
}

/// Draws example 1.33.
pub(super) fn draw_two() -> Sheet {
    let mut sheet = draw();
    sheet.add_ring(
        SECOND,
        [[4.0, 1.0], [5.5, 0.5], [6.0, 2.5], [5.0, 2.0], [4.0, 3.5]],
    );
    sheet
}
