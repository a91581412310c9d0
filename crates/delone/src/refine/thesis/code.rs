//! The pseudocode of the thesis' refinement, and which of its lines tells what.

use crate::tables::FlipLines;

/// Counted from 1.
pub(crate) const CODE: &[&str] = &[
    "for each segment, by its smaller, then its larger end:",
    "  if it is longer than h: divide it into the fewest even pieces that are not",
    "triangulate the domain; number triangles as the sweep emits them, edges by their ends",
    "while the longest edge is longer than h:",
    "  bisect it; edge_flip",
    "save the mesh",
    "while a triangle is skinny: an angle is below α, and not between two segments:",
    "  ABC := the skinniest one, of equals that with the longest edge",
    "  if all angles of ABC are below 90°: bisect its longest edge",
    "  else: M := the circumcenter of ABC, PQR := the triangle that contains M",
    "    if a segment hides M from the corner opposite the longest edge: bisect that edge",
    "    else if PQR has an angle of 90° or more (over 90° − α opposite a segment): bisect its longest edge",
    "    else: insert the circumcenter of PQR",
    "  edge_flip",
    "  if the area of the skinniest was at most 1/100 of what it was at first: give up",
    "if a triangle is skinny still, or an edge longer than h: return to the mesh saved",
    "edge_flip: while an edge is marked:",
    "  AB := the marked edge of the lowest number, A the larger end; unmark it",
    "  if AB is no segment, and D beyond it lies inside the circle of ABC:",
    "    put CD in the place of AB; mark BC, CA, AD and DB",
];

/// Each segment is looked at.
pub(super) const SEGMENTS: u16 = 1;
/// One is divided.
pub(super) const DIVIDE: u16 = 2;
/// The mesh is made.
pub(super) const MESH: u16 = 3;
/// A longest edge is bisected, and its surroundings marked.
pub(super) const SHORTEN: u16 = 5;
/// The first phase is done.
pub(super) const SAVE: u16 = 6;
/// No triangle is skinny.
pub(super) const SKINNY: u16 = 7;
/// The next one is chosen.
pub(super) const SKINNIEST: u16 = 8;
/// It has a circumcenter inside of it.
pub(super) const ACUTE: u16 = 9;
/// Its circumcenter is looked for.
pub(super) const SIGHT: u16 = 10;
/// A segment is in the way.
pub(super) const HIDDEN: u16 = 11;
/// The triangle there is wide, and bisected.
pub(super) const WIDE: u16 = 12;
/// Its circumcenter is inserted.
pub(super) const INSERT: u16 = 13;
/// The mesh saved is taken.
pub(super) const RETURN: u16 = 16;
/// Edges are flipped.
pub(super) const FLIP: FlipLines = FlipLines {
    take: 18,
    examine: 19,
    flip: 20,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_where_they_are_said_to_be() {
        for (line, word) in [
            (SEGMENTS, "for each segment"),
            (DIVIDE, "divide"),
            (MESH, "triangulate"),
            (SHORTEN, "bisect"),
            (SAVE, "save"),
            (SKINNY, "while a triangle is skinny"),
            (SKINNIEST, "skinniest"),
            (ACUTE, "all angles"),
            (SIGHT, "circumcenter of ABC"),
            (HIDDEN, "hides"),
            (WIDE, "90° or more"),
            (INSERT, "insert the circumcenter"),
            (RETURN, "return"),
            (FLIP.take, "lowest number"),
            (FLIP.examine, "inside the circle"),
            (FLIP.flip, "in the place of"),
        ] {
            let text = CODE[usize::from(line) - 1];
            assert!(text.contains(word), "line {line} is: {text}");
        }
    }
}
