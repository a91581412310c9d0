//! The three edits of the tables. Which slot and which row becomes what is part of the algorithm: the
//! numbers decide ties later.
//!
//! Each returns the rows to be looked at again.

use super::{Row, Side, Tables};

impl Tables {
    /// Replaces edge AB, A the larger end, by CD; ABC is the triangle that runs from A to B.
    ///
    /// ```text
    ///        C               C
    ///       / \             /|\         slot of ABC: (D, C, A); slot of BAD: (C, D, B);
    ///      A---B     →     A | B        the row of AB holds CD
    ///       \ /             \|/
    ///        D               D
    /// ```
    pub fn flip(&mut self, row: u32) -> [u32; 4] {
        let sides = self.both_sides(row);
        let [s, g] = sides.expect("bug: flipped an edge of the border");
        let ([a, b], c, d) = (self.ends(s), self.apex(s), self.apex(g));
        let [bc, ca] = [s.next(), s.prev()].map(|side| self.row_of(side));
        let [ad, db] = [g.next(), g.prev()].map(|side| self.row_of(side));
        let [t, u] = [s.triangle, g.triangle];
        self.relocate(bc, s.next(), Side::new(u, 2));
        self.relocate(ca, s.prev(), Side::new(t, 1));
        self.relocate(ad, g.next(), Side::new(t, 2));
        self.relocate(db, g.prev(), Side::new(u, 1));
        self.set_triangle(t, [d, c, a], [row, ca, ad]);
        self.set_triangle(u, [c, d, b], [row, db, bc]);
        self.set_row(row, [c, d], Side::new(t, 0), Some(Side::new(u, 0)), false);
        [bc, ca, ad, db]
    }

    /// Divides edge AB at vertex X; ABC is the first triangle of its row, which runs from A to B.
    ///
    /// ```text
    ///        C               C
    ///       / \             /|\         slot of ABC: (A, X, C); slot of BAD: (B, X, D);
    ///      A---B     →     A-X-B        new, in this order: (C, X, B), (D, X, A);
    ///       \ /             \|/         the row of AB holds XA; new, in this order: XC, XB, XD
    ///        D               D
    /// ```
    ///
    /// Halves of a constraint are constraints.
    pub fn bisect(&mut self, row: u32, x: u32) -> Vec<u32> {
        let Row {
            first: s,
            second: g,
            is_constraint,
            ..
        } = *self.row(row);
        let ([a, b], c) = (self.ends(s), self.apex(s));
        let [bc, ca] = [s.next(), s.prev()].map(|side| self.row_of(side));
        let [t, new] = [s.triangle, self.triangles.len() as u32];
        let [xc, xb, xd] = [0, 1, 2].map(|i| self.rows.len() as u32 + i);
        let beyond = |g: Side| [Side::new(new + 1, 1), Side::new(g.triangle, 0)];
        let [xa_beyond, xb_beyond] = [0, 1].map(|i| g.map(|g| beyond(g)[i]));
        self.relocate(ca, s.prev(), Side::new(t, 2));
        self.relocate(bc, s.next(), Side::new(new, 2));
        self.set_triangle(t, [a, x, c], [row, xc, ca]);
        self.set_triangle(new, [c, x, b], [xc, xb, bc]);
        self.set_row(row, [x, a], Side::new(t, 0), xa_beyond, is_constraint);
        self.set_row(xc, [x, c], Side::new(t, 1), Some(Side::new(new, 0)), false);
        self.set_row(xb, [x, b], Side::new(new, 1), xb_beyond, is_constraint);
        let Some(g) = g else {
            return vec![xc, bc, ca];
        };
        let (d, u) = (self.apex(g), g.triangle);
        let [ad, db] = [g.next(), g.prev()].map(|side| self.row_of(side));
        self.relocate(db, g.prev(), Side::new(u, 2));
        self.relocate(ad, g.next(), Side::new(new + 1, 2));
        self.set_triangle(u, [b, x, d], [xb, xd, db]);
        self.set_triangle(new + 1, [d, x, a], [xd, row, ad]);
        let other = Side::new(new + 1, 0);
        self.set_row(xd, [x, d], Side::new(u, 1), Some(other), false);
        vec![row, xc, xb, xd, bc, ca, ad, db]
    }

    /// Joins vertex X, in triangle ABC, to its corners.
    ///
    /// ```text
    ///          C                   C
    ///         / \                 /|\
    ///        /   \       →       / X \         slot of ABC: (C, X, B); new, in this order:
    ///       /     \             / / \ \        (A, X, C), (B, X, A); new rows, in this order:
    ///      A-------B           A-------B       XA, XB, XC
    /// ```
    pub fn insert(&mut self, t: u32, x: u32) -> Vec<u32> {
        let [a, b, c] = self.triangles[t as usize];
        let [ab, bc, ca] = self.edges_of[t as usize];
        let [u, w] = [0, 1].map(|i| self.triangles.len() as u32 + i);
        let [xa, xb, xc] = [0, 1, 2].map(|i| self.rows.len() as u32 + i);
        self.relocate(ab, Side::new(t, 0), Side::new(w, 2));
        self.relocate(bc, Side::new(t, 1), Side::new(t, 2));
        self.relocate(ca, Side::new(t, 2), Side::new(u, 2));
        self.set_triangle(t, [c, x, b], [xc, xb, bc]);
        self.set_triangle(u, [a, x, c], [xa, xc, ca]);
        self.set_triangle(w, [b, x, a], [xb, xa, ab]);
        self.set_row(xa, [x, a], Side::new(u, 0), Some(Side::new(w, 1)), false);
        self.set_row(xb, [x, b], Side::new(t, 1), Some(Side::new(w, 0)), false);
        self.set_row(xc, [x, c], Side::new(t, 0), Some(Side::new(u, 1)), false);
        vec![xa, xb, xc, ab, bc, ca]
    }

    /// Notes that an edge lies elsewhere in a triangle, or in another.
    fn relocate(&mut self, row: u32, from: Side, to: Side) {
        let row = &mut self.rows[row as usize];
        if row.first == from {
            row.first = to;
        } else {
            debug_assert_eq!(
                row.second,
                Some(from),
                "bug: an edge is not where its row says"
            );
            row.second = Some(to);
        }
    }
}
