//! Point sets on which inexact triangulations fail, or differ from machine to machine. All coordinates are small
//! integers: what looks cocircular or collinear is.

use super::Sheet;

/// A radius that many integers have: 325² is a sum of two squares in 60 ways.
const RADIUS: i32 = 325;

/// Draws all points of integer coordinates on a circle about the origin.
pub(super) fn cocircular() -> Sheet {
    Sheet {
        points: circle([0.0; 2], RADIUS),
        ..Sheet::default()
    }
}

/// Draws points on one line; gaps grow.
pub(super) fn collinear() -> Sheet {
    let points = (0..24).map(|i| f64::from(i * (i + 1) / 2));
    Sheet {
        points: points.map(|t| [3.0 * t, 2.0 * t]).collect(),
        ..Sheet::default()
    }
}

/// Draws the gallery: two rows of three.
pub(super) fn draw() -> Sheet {
    let mut points = Vec::new();
    // A lattice: every square is a tie.
    points.extend((0..36).map(|i| [10 * (i % 6), 10 * (i / 6)].map(f64::from)));
    // Circles within each other, with one center, which is there, too.
    points.extend(circle([100.0, 25.0], 25));
    points.extend(circle([100.0, 25.0], 5));
    points.push([100.0, 25.0]);
    // One line, and a point that hardly leaves it.
    points.extend((0..12).map(|i| [150.0 + 5.0 * f64::from(i), 2.0 * f64::from(i)]));
    points.push([205.0, 23.0]);
    // Equal points: four places, each four times.
    points.extend((0..16).map(|i| [60 + 10 * (i % 2), 80 + 10 * (i / 2 % 2)].map(f64::from)));
    // A fan: one point before many on a line.
    points.extend((0..16).map(|i| [0.0, 70.0 + 3.0 * f64::from(i)]));
    points.push([45.0, 92.0]);
    // A needle: two long rows, close to each other.
    points.extend((0..20).map(|i| [110 + 5 * (i % 10), 80 + i / 10].map(f64::from)));
    Sheet {
        points,
        ..Sheet::default()
    }
}

/// Lists the integer points at a distance from a center, by abscissa and ordinate.
fn circle([x, y]: [f64; 2], radius: i32) -> Vec<[f64; 2]> {
    let offsets = move |dx: i32| {
        let square = radius * radius - dx * dx;
        let dy = (square as u32).isqrt() as i32;
        let both = [-dy, dy].into_iter().skip(usize::from(dy == 0));
        both.filter(move |_| dy * dy == square)
            .map(move |dy| [x + f64::from(dx), y + f64::from(dy)])
    };
    (-radius..=radius).flat_map(offsets).collect()
}
