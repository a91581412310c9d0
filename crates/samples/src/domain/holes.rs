//! Holes in the unit square, each in a cell of its own, so that none touches another.

use super::Drawing;
use super::rings::{Rings, on_circle, polygon, square};
use crate::Random;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Mean number of sides of a hole.
const SIDES: usize = 18;
/// How many buildings a district is wide.
const DISTRICT: usize = 8;

/// Draws round holes of 8 to 28 sides that take a quarter of the square: with 18,004 segments, 1000 of
/// them. Gaps between them are a tenth of a hole's width and more.
pub fn round(count: usize, random: &mut Random) -> Drawing {
    let number = count.saturating_sub(4) / SIDES;
    let mut rings = with_frame(count, SIDES * number);
    let cells = Cells::drawn(number, random);
    let mut before = SIDES;
    for i in 0..number {
        // In pairs, so that the sum is known; the last of an odd number has the mean.
        let sides = if i % 2 == 1 {
            2 * SIDES - before
        } else if i + 1 == number {
            SIDES
        } else {
            SIDES - 10 + random.below(21)
        };
        before = sides;
        let radius = cells.width * random.between(0.16, 0.42);
        let center = cells.place(i, 0.46 * cells.width - radius, random);
        let phase = random.unit() * PI;
        let hole = polygon(center, sides, phase, |_| radius * random.between(0.9, 1.0));
        rings.add_hole(hole, center);
    }
    rings.finish()
}

/// Draws a town: rectangular buildings, turned with their district and a little on their own.
pub fn town(count: usize, random: &mut Random) -> Drawing {
    let number = count.saturating_sub(4) / 4;
    let mut rings = with_frame(count, 4 * number);
    let cells = Cells::drawn(number, random);
    let districts = cells.side.div_ceil(DISTRICT);
    let turns: Vec<f64> = (0..districts * districts)
        .map(|_| FRAC_PI_2 * random.unit())
        .collect();
    for i in 0..number {
        let [column, row] = cells.cell(i);
        let turn = turns[row / DISTRICT * districts + column / DISTRICT];
        let half_diagonal = cells.width * random.between(0.3, 0.48);
        let center = cells.place(i, 0.49 * cells.width - half_diagonal, random);
        let flat = random.between(0.25, FRAC_PI_4);
        let turn = turn + random.between(-0.05, 0.05);
        let corners = [-flat, flat, PI - flat, PI + flat];
        let building = corners.map(|angle| on_circle(center, half_diagonal, turn + angle));
        rings.add_hole(building.to_vec(), center);
    }
    rings.finish()
}

/// Draws the joints between paving stones: convex quadrilaterals left out, with gaps between them of
/// 1 to 30 per cent of their width.
pub fn joints(count: usize, random: &mut Random) -> Drawing {
    let number = count.saturating_sub(4) / 4;
    let mut rings = with_frame(count, 4 * number);
    let cells = Cells::drawn(number, random);
    let corners = shaken_lattice(cells.side, random);
    for i in 0..number {
        let [column, row] = cells.cell(i);
        let at = |x: usize, y: usize| corners[(row + y) * (cells.side + 1) + column + x];
        let stone = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
        let center = [0, 1].map(|c| stone.iter().map(|p| p[c]).sum::<f64>() / 4.0);
        let left = 1.0 - 0.01 * libm::pow(30.0, random.unit());
        let shrunk = stone.map(|p| [0, 1].map(|c| center[c] + left * (p[c] - center[c])));
        rings.add_hole(shrunk.to_vec(), center);
    }
    rings.finish()
}

/// Starts with the square's border, of all segments that are not `spent`.
fn with_frame(count: usize, spent: usize) -> Rings {
    let mut rings = Rings::default();
    rings.add(square(count - spent));
    rings
}

/// Returns the points of a square lattice over the unit square, `side` cells wide, each moved by a
/// fifth of a cell at most: the cells stay convex.
fn shaken_lattice(side: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let mut moved = |i: usize| {
        let shift = random.between(-0.2, 0.2);
        let place = i as f64 + if i == 0 || i == side { 0.0 } else { shift };
        place / side as f64
    };
    (0..(side + 1) * (side + 1))
        .map(|i| [i % (side + 1), i / (side + 1)].map(&mut moved))
        .collect()
}

/// Some cells of a square lattice over the unit square, in random order.
struct Cells {
    /// How many are in a row.
    side: usize,
    width: f64,
    chosen: Vec<usize>,
}

impl Cells {
    /// Chooses `number` of the cells of the smallest lattice that has so many.
    fn drawn(number: usize, random: &mut Random) -> Self {
        let side = number.saturating_sub(1).isqrt() + 1;
        let mut chosen: Vec<usize> = (0..side * side).collect();
        random.shuffle(&mut chosen);
        Self {
            side,
            width: 1.0 / side as f64,
            chosen,
        }
    }

    /// Returns column and row of the cell that was chosen as number `i`.
    fn cell(&self, i: usize) -> [usize; 2] {
        let cell = self.chosen[i];
        [cell % self.side, cell / self.side]
    }

    /// Draws a place in that cell, no farther than `reach` from its middle in x and y.
    fn place(&self, i: usize, reach: f64, random: &mut Random) -> [f64; 2] {
        self.cell(i)
            .map(|c| (c as f64 + 0.5) * self.width + random.between(-reach, reach))
    }
}
