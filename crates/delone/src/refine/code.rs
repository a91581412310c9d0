//! The pseudocode of the default strategy, and which of its lines tells what.

/// Counted from 1.
pub(crate) const CODE: &[&str] = &[
    "triangulate the domain",
    "if one size is asked for: cut segments evenly, and sow a lattice of equilateral triangles",
    "while anything waits, the first of these:",
    "  an encroached subsegment: split it",
    "  the most oversized triangle: if its longest edge is a subsegment and too long, split that",
    "    else: try its circumcenter",
    "  the skinny triangle with the shortest edge: if its angle is the input's, leave it alone",
    "    else if it has a corner that was sown: move that to where fewer triangles are bad",
    "    else: try its off-center, and four other places",
    "to try places: dig the cavity of each, the triangles in whose circles it lies and that it sees",
    "  if the first encroaches upon a subsegment: split that; if none has room: leave the triangle alone",
    "  else: insert the one that leaves the fewest skinny triangles, of equals the roomiest",
    "to split a subsegment: put a vertex in its middle, at acute corners on a common circle about them",
    "for each free vertex, as often as asked for: move it to the centers of the circles around, if that is better",
];

/// The domain is triangulated.
pub(super) const TRIANGULATE: u16 = 1;
/// A lattice is sown.
pub(super) const SOW: u16 = 2;
/// Nothing waits any more.
pub(super) const LOOP: u16 = 3;
/// A subsegment is encroached upon.
pub(super) const ENCROACHED: u16 = 4;
/// A triangle is too large because a subsegment is too long.
pub(super) const LONG: u16 = 5;
/// A triangle is too large.
pub(super) const LARGE: u16 = 6;
/// A small angle is the input's.
pub(super) const GIVEN: u16 = 7;
/// A vertex of the lattice is moved.
pub(super) const MOVE: u16 = 8;
/// A triangle is skinny.
pub(super) const SKINNY: u16 = 9;
/// A subsegment is in the way, or nothing has room.
pub(super) const REJECT: u16 = 11;
/// A vertex is inserted.
pub(super) const INSERT: u16 = 12;
/// A subsegment is split.
pub(super) const SPLIT: u16 = 13;
/// A vertex is moved to a better place.
pub(super) const SMOOTH: u16 = 14;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_where_they_are_said_to_be() {
        for (line, word) in [
            (TRIANGULATE, "triangulate"),
            (SOW, "sow"),
            (LOOP, "while anything waits"),
            (ENCROACHED, "encroached subsegment"),
            (LONG, "too long"),
            (LARGE, "circumcenter"),
            (GIVEN, "the input's"),
            (MOVE, "was sown"),
            (SKINNY, "off-center"),
            (REJECT, "if the first encroaches"),
            (INSERT, "insert"),
            (SPLIT, "to split"),
            (SMOOTH, "if that is better"),
        ] {
            let text = CODE[usize::from(line) - 1];
            assert!(text.contains(word), "line {line} is: {text}");
        }
    }
}
